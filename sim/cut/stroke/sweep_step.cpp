// A step of the blade through one group of pieces.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sim/cut/commit/commit.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/plan/air_edges.h"
#include "sim/cut/plan/bridges.h"
#include "sim/cut/plan/mirrors.h"
#include "sim/cut/plan/strip.h"
#include "sim/cut/stroke/cutter_state.h"
#include "sim/cut/stroke/ladder.h"
#include "sim/cut/stroke/resume.h"
#include "sim/cut/stroke/step_result.h"

namespace kerf {

using cut::Sweep;

namespace {

// After so many refused steps in a row the front is let go; it stays as a slit.
constexpr int kRefusalsBeforeDetach = 3;
// Sliding along the axis in the air by more than this many times the advance takes the rung along.
constexpr double kAxialSlide = 4;
constexpr double kBinSize = 1.0;
// Of the body at rest: a step that would change its volume by more is not done. The bar is 1e-9 for
// all pieces together.
constexpr double kMostVolumeChange = 5e-10;
// Levels of the retry ladder that are tried for each way to go on after a refusal.
constexpr int kAttemptsOfResumption = 2;
// How far older slits are seen open (SweepStep), and the levels that are tried for each together
// with what the pass has divided of them.
constexpr std::array kOpenings{0.1, 0.2, 0.3};
constexpr int kAttemptsOfOpening = 2;
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

/// `from`: the rung, measured along `to`. It stays as far behind the blade as it is: started anew,
/// a blade that is drawn through the body along itself would never be far enough ahead to cut.
void Cutter::State::slideRung(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep) {
    const auto behind = [&](const RungNode& node) -> Vec3 {
        return node.position - (to.a + (to.b - to.a) * node.s);
    };
    sweep.blade = {to.a + behind(from.front()), to.b + behind(from.back())};
    setRung({{sweep.blade.a, 0, -1, false}, {sweep.blade.b, 1, -1, false}}, sweep);
}

void Cutter::State::setRung(std::vector<RungNode> next, Sweep& sweep) {
    sweep.rung = std::move(next);
    if (isInAir(sweep.rung)) {
        sweep.heading = Vec3::Zero();
    }
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
    if (goesInParts(to, from, sweep)) {
        const CutOutcome otherwise = cut::isWithdrawing(mesh, to, h, sweep.lastAdvance, from)
                                         ? CutOutcome::withdrawing
                                         : CutOutcome::waiting;
        const std::vector<cut::RungPart> parts =
            cut::partsAhead(to, sweep.edgeLength, least, sweep.heading, from);
        return parts.empty() ? outcome(otherwise) : cutParts(to, parts, sweep);
    }
    if (motion.advance < std::max(least, kStandingStill * h)) {
        const bool slides = motion.axial > kAxialSlide * motion.advance && motion.axial > least;
        if (!motion.anyAttached && slides) {
            slideRung(to, from, sweep);
        }
        return outcome(CutOutcome::waiting);
    }
    if (cut::isWithdrawing(mesh, to, h, sweep.lastAdvance, from)) {
        return outcome(CutOutcome::withdrawing);
    }
    if (isInAir(from)) {
        const std::vector<cut::RungPart> parts = cut::partsInAir(to, sweep.edgeLength, from);
        if (!parts.empty()) {
            return cutParts(to, parts, sweep);
        }
    }
    return cut(to, from, sweep);
}

// A part that the blade has left behind stays until the blade is ahead of it again.
bool Cutter::State::goesInParts(const Blade& to, const std::vector<RungNode>& from,
                                const Sweep& sweep) {
    return !sweep.heading.isZero(0) &&
           (sweep.isUneven || cut::isPartlyBehind(to, sweep.edgeLength, sweep.heading, from));
}

/// From the last part to the first: the nodes before it keep their places in the rung. Where one is
/// refused the whole blade goes on.
CutResult Cutter::State::cutParts(const Blade& to, const std::vector<cut::RungPart>& parts,
                                  Sweep& sweep) {
    CutResult sum = outcome(CutOutcome::air);
    int staying = cut::sizeOf(sweep.rung);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        CutResult result = outcome(CutOutcome::refused);
        if (!findStep([&] { return climb(to, *part, sweep, result); })) {
            tie(sweep);
            std::vector<RungNode> from = sweep.rung;
            cut::reparametrize(to, h, from);
            addTo(sum, cut(to, from, sweep));
            return sum;
        }
        addTo(sum, result);
        staying -= part->count;
    }
    moveOn(to, sum, sweep);
    sum.statistics.cutPieces = std::min(sum.statistics.cutPieces, 1);
    sweep.isUneven = staying > 0;
    if (!sweep.isUneven && isInAir(sweep.rung)) {
        setRung({sweep.rung.front(), sweep.rung.back()}, sweep);  // without where it crossed
    }
    return sum;
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
    const cut::RungPart whole{from, {}, 0, cut::sizeOf(sweep.rung)};
    if (findStep(
            [&] { return climb(to, whole, sweep, result) || resume(to, from, sweep, result); })) {
        moveOn(to, result, sweep);
        sweep.isUneven = false;
        return result;
    }
    result.statistics.refusedPieces = 1;
    countRefusal(to, sweep);
    return result;
}

// First with walls mirrored, and without where that alone is in the way.
bool Cutter::State::findStep(const std::function<bool()>& find) {
    mirrors = Mirrors::wanted;
    if (find()) {
        return true;
    }
    if (mirrors != Mirrors::missed) {
        return false;
    }
    mirrors = Mirrors::waived;
    return find();
}

// The retry ladder: with older slits along the blade seen open, then with all as they are; a pass
// that once had to do without stays so.
bool Cutter::State::climb(const Blade& to, const cut::RungPart& part, Sweep& sweep,
                          CutResult& result) {
    const cut::BroadPhase candidates = findCandidates(to, sweep, part.rung);
    if (sweep.opensSlits && climbOpened(to, part, candidates, sweep, result)) {
        return true;
    }
    return !sweep.opensSlits &&
           tryLevels(to, part, candidates, kNoOpening, cut::attemptCount(), sweep, result);
}

// A blade that leaves an older slit at an angle may meet walls again that it saw open before: they
// are then seen open farther.
bool Cutter::State::climbOpened(const Blade& to, const cut::RungPart& part,
                                const cut::BroadPhase& candidates, Sweep& sweep,
                                CutResult& result) {
    const auto opened = [&](double opening, bool takesSeamsAlong) {
        return cut::SlitOpening(mesh, candidates,
                                {part.rung, to, sweep.edgeLength, stroke, sweep.firstVertexOfPass,
                                 sweep.onSeams, sweep.sides, opening, takesSeamsAlong});
    };
    const cut::SlitOpening first = opened(kOpenings.front(), false);
    if (tryLevels(to, part, candidates, first, cut::attemptCount(), sweep, result)) {
        return true;
    }
    if (first.empty()) {
        return false;
    }
    const std::map<int, Vec3> sides = sweep.sides;
    for (const double opening : kOpenings) {
        if (tryLevels(to, part, candidates, opened(opening, true), kAttemptsOfOpening, sweep,
                      result)) {
            return true;
        }
        sweep.sides = sides;
    }
    sweep.opensSlits = false;
    return false;
}

bool Cutter::State::tryLevels(const Blade& to, const cut::RungPart& part,
                              const cut::BroadPhase& candidates, const cut::SlitOpening& opening,
                              int levels, Sweep& sweep, CutResult& result) {
    cut::RungPart clear = part;
    cut::AirTies ties;
    cut::clearAirEdges(
        mesh, candidates, opening, to, sweep.edgeLength,
        [&]() -> const cut::AirTies& {
            makeWaitingTies(sweep);
            return ties = sweep.airTies.part(part.first, part.first + part.count - 1,
                                             part.beforeFirst);
        },
        clear.rung);
    for (int i = 0; i < levels; ++i) {
        if (attempt(to, clear, candidates, opening, i, sweep, result)) {
            return true;
        }
    }
    return false;
}

// What a moving body does not let through now it often does in the next step.
bool Cutter::State::mayWait(const Sweep& sweep) const {
    return sweep.refusedInARow + 1 < kRefusalsBeforeDetach &&
           std::ranges::any_of(sweep.rung, [&](const RungNode& node) {
               return node.vertex >= 0 && !mesh.velocity(node.vertex).isZero(0);
           });
}

// Lets go of the front, and sweeps anew across the walls behind it: close beside them where the
// body surely parts so, and then on to the blade; otherwise steeply, and if need be without proof.
bool Cutter::State::resume(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep,
                           CutResult& result) {
    if (mayWait(sweep)) {
        return false;
    }
    const auto startsBy = [&](const std::vector<cut::Resumption>& ways) {
        return std::ranges::any_of(
            ways, [&](const cut::Resumption& way) { return startAnew(way, sweep, result); });
    };
    piecesToCross = cut::piecesOfFront(from, pieces.ofVertex());
    const bool mayProve = !piecesToCross.empty();
    if (mayProve && startsBy(cut::crossings(from, to, std::min(h, sweep.edgeLength)))) {
        piecesToCross.clear();
        sweepOn(to, sweep, result);
        return true;
    }
    const std::vector<cut::Resumption> steep = cut::resumptions(from, to, sweep.edgeLength);
    const bool crosses = mayProve && startsBy(steep);
    piecesToCross.clear();
    return crosses || startsBy(steep);
}

bool Cutter::State::startAnew(const cut::Resumption& way, Sweep& sweep, CutResult& result) {
    Sweep anew = sweep;
    startPass(anew);
    cut::RungPart start{way.rung, {}, 0, cut::sizeOf(anew.rung)};
    cut::reparametrize(way.blade, h, start.rung);
    const cut::BroadPhase candidates = findCandidates(way.blade, anew, start.rung);
    for (int i = 0; i < kAttemptsOfResumption; ++i) {
        if (attempt(way.blade, start, candidates, kNoOpening, i, anew, result)) {
            sweep = std::move(anew);
            sweep.opensSlits = false;
            result.statistics.resumed = 1;
            return true;
        }
    }
    return false;
}

// What can't be done now waits for the next step.
void Cutter::State::sweepOn(const Blade& to, Sweep& sweep, CutResult& result) {
    tie(sweep);
    cut::RungPart whole{sweep.rung, {}, 0, cut::sizeOf(sweep.rung)};
    cut::reparametrize(to, h, whole.rung);
    CutResult more = outcome(CutOutcome::refused);
    if (climb(to, whole, sweep, more)) {
        addTo(result, more);
        result.statistics.cutPieces = 1;
    }
}

void Cutter::State::requireVolume(const cut::StepPlan& plan) const {
    const double allowed = kMostVolumeChange * restVolume;
    if (std::fabs(plan.volumeChange) > allowed || std::fabs(plan.restVolumeChange) > allowed) {
        throw cut::StepFailure{"the step would change the volume"};
    }
}

void Cutter::State::requireCrossing(const cut::PlannedStep& step) const {
    if (!piecesToCross.empty() &&
        (step.air || cut::leavesBridge(mesh, stroke, piecesToCross, step.plan))) {
        throw cut::StepFailure{"the new walls do not cross the old ones"};
    }
}

void Cutter::State::requireMirrors(const cut::StepPlan& plan, double edge) {
    if (mirrors != Mirrors::waived && !cut::keepsMirrors(mesh, plan, cut::kCloseNoise * edge)) {
        mirrors = Mirrors::missed;
        throw cut::StepFailure{"the two sides of a wall would divide differently"};
    }
}

bool Cutter::State::attempt(const Blade& to, const cut::RungPart& part,
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
                            part.rung,
                            to,
                            part.span,
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
        requireCrossing(step);
        requireVolume(step.plan);
        requireMirrors(step.plan, edge);
        result = accept(to, step, part, sweep);
        result.statistics.tries = tries;
        result.reason = reason;
        return true;
    } catch (const cut::StepFailure& failure) {
        result.reason = failure.reason;
        return false;
    }
}

CutResult Cutter::State::accept(const Blade& to, const cut::PlannedStep& step,
                                const cut::RungPart& part, Sweep& sweep) {
    sweep.refusedInARow = 0;
    if (step.air) {
        setRung(cut::replaced(sweep.rung, part, {step.air->endA, step.air->endB}), sweep);
        return outcome(CutOutcome::air);
    }
    if (settings.cleanUp && !cleanup) {
        cleanup.emplace(mesh, *edgeLengths);
    }
    cut::CommitResult committed =
        cut::commit(mesh, step.plan, sweep.edgeLength, stroke, cut::stayingFront(sweep.rung, part));
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
    const Vec3 way = cut::advanceOf(to, sweep.edgeLength, part.rung, committed.rung);
    sweep.heading = way.isZero(0) ? sweep.heading : way;
    std::vector<RungNode> next = cut::replaced(sweep.rung, part, committed.rung);
    if (isInAir(next)) {
        sweep.heading = Vec3::Zero();
        startPass(sweep);
    }
    sweep.rung = std::move(next);  // tied once all of the step is done
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
