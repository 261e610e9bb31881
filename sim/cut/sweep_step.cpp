// A step of the blade through one group of pieces.

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/cut/air_edges.h"
#include "sim/cut/commit.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/cutter_state.h"
#include "sim/cut/ladder.h"
#include "sim/cut/mirrors.h"
#include "sim/cut/resume.h"
#include "sim/cut/step_result.h"
#include "sim/cut/strip.h"

namespace kerf {

using cut::Sweep;

namespace {

// After so many refused steps in a row the front is let go; it stays as a slit.
constexpr int kRefusalsBeforeDetach = 3;
// Sliding along the axis in the air by more than this many times the advance restarts the rung.
constexpr double kAxialSlide = 4;
constexpr double kBinSize = 1.0;
// Of the body at rest: a step that would change its volume by more is not done. The bar is 1e-9 for
// all pieces together.
constexpr double kMostVolumeChange = 5e-10;
// Levels of the retry ladder that are tried for each way to go on after a refusal.
constexpr int kAttemptsOfResumption = 2;
const cut::SlitOpening kNoOpening;

bool isInAir(const std::vector<RungNode>& rung) {
    return std::all_of(rung.begin(), rung.end(), [](const RungNode& n) { return n.vertex < 0; });
}

}  // namespace

void Cutter::State::startPass(Sweep& sweep) {
    sweep.pass = ++pass;
    sweep.firstVertexOfPass = mesh.vertexCount();
    sweep.onSeams.clear();
    sweep.sides.clear();
    sweep.opensSlits = true;
}

// The rung carries the offset of the pass from the start: otherwise a blade that is put down
// exactly on a vertex would stay there in every retry.
void Cutter::State::placeRung(const Blade& at, Sweep& sweep) {
    startPass(sweep);
    const auto end = [&](const Vec3& p, double s) {
        const Vec3 offset = cut::bladeOffset(settings.offset * h, 1, settings.seed, sweep.pass, s);
        return RungNode{p + offset, s, -1, false};
    };
    setRung({end(at.a, 0), end(at.b, 1)}, sweep);
    sweep.blade = at;
    sweep.lastAdvance = Vec3::Zero();
}

void Cutter::State::setRung(std::vector<RungNode> next, Sweep& sweep) {
    sweep.rung = std::move(next);
    tie(sweep);
}

// While all lies where it rests, ties would hold the rung where it is. They can wait: where they
// are to be made is known also when the body has begun to move.
void Cutter::State::tie(Sweep& sweep) {
    sweep.edgeLength = edgeLengthAbout(sweep.rung);
    sweep.tiesWait = atRest && finder == nullptr;
    if (sweep.tiesWait) {
        sweep.airTies = {};
        findTriangles().bounds();  // the tree knows the shape at rest from now on
    } else {
        sweep.airTies = cut::AirTies(mesh, findTriangles(), isOuter(sweep), sweep.edgeLength,
                                     sweep.rung, cut::SkinShape::current);
    }
}

/// Before the tree hears that anything has moved.
void Cutter::State::makeWaitingTies(Sweep& sweep) {
    if (std::exchange(sweep.tiesWait, false)) {
        sweep.airTies = cut::AirTies(mesh, findTriangles(), isOuter(sweep), sweep.edgeLength,
                                     sweep.rung, cut::SkinShape::rest);
    }
}

std::function<bool(int)> Cutter::State::isOuter(const Sweep& sweep) const {
    return [this, group = sweep.group](int t) {
        const bool ownWall = mesh.kind(t) == SurfaceKind::wall && mesh.wallLabel(t) / 2 == stroke;
        return !ownWall && groupOfVertex(mesh.triangle(t)[0]) == group;
    };
}

CutResult Cutter::State::advance(const Blade& to, Gate gate, Sweep& sweep) {
    std::vector<RungNode> from = sweep.rung;
    const double least = gateLength(gate, sweep.edgeLength);
    const cut::SweepMotion motion = cut::reparametrize(to, h, from);
    if (motion.advance < std::max(least, kStandingStill * h)) {
        const bool slides = motion.axial > kAxialSlide * motion.advance && motion.axial > least;
        if (!motion.anyAttached && slides) {
            placeRung(to, sweep);
        }
        return outcome(CutOutcome::waiting);
    }
    if (cut::isWithdrawing(mesh, to, h, sweep.lastAdvance, from)) {
        return outcome(CutOutcome::withdrawing);
    }
    return cut(to, from, sweep);
}

cut::BroadPhase Cutter::State::findCandidates(const Blade& to, const Sweep& sweep,
                                              const std::vector<RungNode>& from) {
    std::vector<Vec3> points{to.a, to.b};
    for (const RungNode& node : from) {
        points.push_back(node.position);
    }
    return {
        mesh,
        findTriangles(),
        to,
        points,
        margin(sweep.edgeLength),
        kBinSize * sweep.edgeLength,
        [this, group = sweep.group](int t) { return groupOfVertex(mesh.triangle(t)[0]) == group; }};
}

// Nothing is committed until one attempt succeeds.
CutResult Cutter::State::cut(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep) {
    CutResult result = outcome(CutOutcome::refused);
    mirrors = Mirrors::wanted;
    bool done = findStep(to, from, sweep, result);
    if (!done && mirrors == Mirrors::missed) {
        mirrors = Mirrors::waived;
        done = findStep(to, from, sweep, result);
    }
    if (done) {
        moveOn(to, result, sweep);
        return result;
    }
    result.statistics.refusedPieces = 1;
    countRefusal(to, sweep);
    return result;
}

bool Cutter::State::findStep(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep,
                             CutResult& result) {
    return climb(to, from, sweep, result) || resume(to, from, sweep, result);
}

// The retry ladder: with older slits along the blade seen open, then with all as they are; a pass
// that once had to do without stays so.
bool Cutter::State::climb(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep,
                          CutResult& result) {
    const cut::BroadPhase candidates = findCandidates(to, sweep, from);
    const auto tryAll = [&](const cut::SlitOpening& opening) {
        std::vector<RungNode> clear = from;
        cut::clearAirEdges(
            mesh, candidates, opening, to, sweep.edgeLength,
            [&]() -> const cut::AirTies& {
                makeWaitingTies(sweep);
                return sweep.airTies;
            },
            clear);
        for (int i = 0; i < cut::attemptCount(); ++i) {
            if (attempt(to, clear, candidates, opening, i, sweep, result)) {
                return true;
            }
        }
        return false;
    };
    if (sweep.opensSlits) {
        const cut::SlitOpening opening(mesh, candidates,
                                       {from, to, sweep.edgeLength, stroke, sweep.firstVertexOfPass,
                                        sweep.onSeams, sweep.sides});
        if (tryAll(opening)) {
            return true;
        }
        sweep.opensSlits = opening.empty();
    }
    return !sweep.opensSlits && tryAll(kNoOpening);
}

// Lets go of the front, and sweeps anew across the walls behind it.
bool Cutter::State::resume(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep,
                           CutResult& result) {
    for (const cut::Resumption& way : cut::resumptions(from, to, sweep.edgeLength)) {
        Sweep anew = sweep;
        startPass(anew);
        std::vector<RungNode> start = way.rung;
        cut::reparametrize(way.blade, h, start);
        const cut::BroadPhase candidates = findCandidates(way.blade, anew, start);
        for (int i = 0; i < kAttemptsOfResumption; ++i) {
            if (attempt(way.blade, start, candidates, kNoOpening, i, anew, result)) {
                sweep = std::move(anew);
                sweep.opensSlits = false;
                result.statistics.resumed = 1;
                return true;
            }
        }
    }
    return false;
}

void Cutter::State::requireVolume(const cut::StepPlan& plan) const {
    const double allowed = kMostVolumeChange * restVolume;
    if (std::fabs(plan.volumeChange) > allowed || std::fabs(plan.restVolumeChange) > allowed) {
        throw cut::StepFailure{"the step would change the volume"};
    }
}

void Cutter::State::requireMirrors(const cut::StepPlan& plan, double edge) {
    if (mirrors != Mirrors::waived && !cut::keepsMirrors(mesh, plan, cut::kCloseNoise * edge)) {
        mirrors = Mirrors::missed;
        throw cut::StepFailure{"the two sides of a wall would divide differently"};
    }
}

bool Cutter::State::attempt(const Blade& to, const std::vector<RungNode>& from,
                            const cut::BroadPhase& candidates, const cut::SlitOpening& opening,
                            int level, Sweep& sweep, CutResult& result) {
    const std::uint64_t retrySeed =
        settings.seed * 7 + static_cast<std::uint64_t>(mesh.triangleSlots());
    const double edge = sweep.edgeLength;
    const double scale = h / edge;  // shares that stay shares of h
    Bounds bodyBox = findTriangles().bounds();
    bodyBox.widen(kBroadPhaseMargin * edge);  // predicates may see vertices that far outside
    const cut::StepInput in{mesh,
                            candidates,
                            pieces.ofVertex(),
                            surface,
                            opening,
                            from,
                            to,
                            edge,
                            settings.offset * scale,
                            *edgeLengths,
                            settings.seed,
                            stroke,
                            sweep.pass,
                            sweep.firstVertexOfPass,
                            cut::attemptAt(level, settings.tolerance * scale, retrySeed),
                            bodyBox,
                            atRest};
    const int tries = result.statistics.tries + 1;
    const std::string reason = result.reason;
    result.statistics.tries = tries;
    try {
        const cut::PlannedStep step = cut::planStep(in);
        requireVolume(step.plan);
        requireMirrors(step.plan, edge);
        result = accept(step, sweep);
        result.statistics.tries = tries;
        result.reason = reason;
        return true;
    } catch (const cut::StepFailure& failure) {
        result.reason = failure.reason;
        return false;
    }
}

CutResult Cutter::State::accept(const cut::PlannedStep& step, Sweep& sweep) {
    sweep.refusedInARow = 0;
    if (step.air) {
        setRung({step.air->endA, step.air->endB}, sweep);
        return outcome(CutOutcome::air);
    }
    if (settings.cleanUp && !cleanup) {
        cleanup.emplace(mesh, *edgeLengths);
    }
    cut::CommitResult committed = cut::commit(mesh, step.plan, sweep.edgeLength, stroke);
    const std::vector<int> changed = changedTriangles(committed.delta);
    follow(changed, sweep.group);
    surface.follow(changed, 0);
    madeWalls = true;
    sweep.onSeams.insert(committed.onSeams.begin(), committed.onSeams.end());
    CutResult result = outcome(CutOutcome::cut);
    result.delta = std::move(committed.delta);
    result.statistics.cutPieces = 1;
    result.statistics.touchedTriangles = cut::sizeOf(step.plan.subdivision.replaced);
    result.statistics.wallTriangles = step.wallTriangles;
    result.statistics.splitVertices = committed.splitVertices;
    result.statistics.patterns = step.plan.subdivision.patterns;
    result.statistics.seeds = step.seeds;
    result.statistics.volumeChange = step.plan.volumeChange;
    if (isInAir(committed.rung)) {
        startPass(sweep);
    }
    sweep.rung = std::move(committed.rung);  // tied once all of the step is done
    return result;
}

void Cutter::State::moveOn(const Blade& to, const CutResult& result, Sweep& sweep) {
    const Blade from = std::exchange(sweep.blade, to);
    if (result.outcome == CutOutcome::cut) {
        sweep.lastAdvance = 0.5 * (to.a - from.a + to.b - from.b);
    }
}

void Cutter::State::countRefusal(const Blade& to, Sweep& sweep) {
    if (++sweep.refusedInARow >= kRefusalsBeforeDetach) {
        sweep.refusedInARow = 0;
        placeRung(to, sweep);
    }
}

}  // namespace kerf
