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

using cut::GroupStroke;

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
// How far older slits are seen open (OpeningInput), and the levels that are tried for each together
// with what the transit has divided of them.
constexpr std::array kOpenings{0.1, 0.2, 0.3};
constexpr int kAttemptsOfOpening = 2;
const cut::SlitOpening kNoOpening;

bool isInAir(const std::vector<RungNode>& rung) {
    return std::all_of(rung.begin(), rung.end(), [](const RungNode& n) { return n.vertex < 0; });
}

}  // namespace

void Cutter::State::startTransit(GroupStroke& group) {
    group.transit = ++transit;
    group.firstVertexOfTransit = mesh.vertexCount();
    group.onSeams.clear();
    group.sides.clear();
    group.opensSlits = true;
}

// The rung carries the offset of the transit from the start: otherwise a blade that is put down
// exactly on a vertex would stay there in every retry.
void Cutter::State::placeRung(const Blade& at, GroupStroke& group) {
    startTransit(group);
    const auto end = [&](const Vec3& p, double s) {
        const Vec3 offset =
            cut::bladeOffset(settings.offset * h, 1, settings.seed, group.transit, s);
        return RungNode{p + offset, s, -1, false};
    };
    setRung({end(at.a, 0), end(at.b, 1)}, group);
    group.blade = at;
    group.lastAdvance = Vec3::Zero();
}

/// `from`: the rung, measured along `to`. It stays as far behind the blade as it is: started anew,
/// a blade that is drawn through the body along itself would never be far enough ahead to cut.
void Cutter::State::slideRung(const Blade& to, const std::vector<RungNode>& from,
                              GroupStroke& group) {
    const auto behind = [&](const RungNode& node) -> Vec3 {
        return node.position - (to.a + (to.b - to.a) * node.s);
    };
    group.blade = {to.a + behind(from.front()), to.b + behind(from.back())};
    setRung({{group.blade.a, 0, -1, false}, {group.blade.b, 1, -1, false}}, group);
}

void Cutter::State::setRung(std::vector<RungNode> next, GroupStroke& group) {
    group.rung = std::move(next);
    if (isInAir(group.rung)) {
        group.heading = Vec3::Zero();
    }
    tie(group);
}

// While all lies where it rests, ties would hold the rung where it is. They can wait: where they
// are to be made is known also when the body has begun to move.
void Cutter::State::tie(GroupStroke& group) {
    group.edgeLength = edgeLengthAbout(group.rung);
    group.tiesWait = atRest && finder == nullptr;
    if (group.tiesWait) {
        group.airTies = {};
        findTriangles().bounds();  // the tree knows the shape at rest from now on
    } else {
        group.airTies = cut::AirTies(mesh, findTriangles(), isOuter(group), group.edgeLength,
                                     group.rung, cut::SkinShape::current);
    }
}

/// Before the tree hears that anything has moved.
void Cutter::State::makeWaitingTies(GroupStroke& group) {
    if (std::exchange(group.tiesWait, false)) {
        group.airTies = cut::AirTies(mesh, findTriangles(), isOuter(group), group.edgeLength,
                                     group.rung, cut::SkinShape::rest);
    }
}

std::function<bool(int)> Cutter::State::isOuter(const GroupStroke& group) const {
    return [this, number = group.number](int t) {
        const bool ownWall = mesh.kind(t) == SurfaceKind::wall && mesh.wallLabel(t) / 2 == stroke;
        return !ownWall && groupOfVertex(mesh.triangle(t)[0]) == number;
    };
}

CutResult Cutter::State::advance(const Blade& to, Gate gate, GroupStroke& group) {
    std::vector<RungNode> from = group.rung;
    const double least = gateLength(gate, group.edgeLength);
    const cut::BladeMotion motion = cut::reparametrize(to, h, from);
    if (goesInParts(to, from, group)) {
        const CutOutcome otherwise = cut::isWithdrawing(mesh, to, h, group.lastAdvance, from)
                                         ? CutOutcome::withdrawing
                                         : CutOutcome::waiting;
        const std::vector<cut::RungPart> parts =
            cut::partsAhead(to, group.edgeLength, least, group.heading, from);
        return parts.empty() ? outcome(otherwise) : cutParts(to, parts, group);
    }
    if (motion.advance < std::max(least, kStandingStill * h)) {
        const bool slides = motion.axial > kAxialSlide * motion.advance && motion.axial > least;
        if (!motion.anyAttached && slides) {
            slideRung(to, from, group);
        }
        return outcome(CutOutcome::waiting);
    }
    if (cut::isWithdrawing(mesh, to, h, group.lastAdvance, from)) {
        return outcome(CutOutcome::withdrawing);
    }
    if (isInAir(from)) {
        const std::vector<cut::RungPart> parts = cut::partsInAir(to, group.edgeLength, from);
        if (!parts.empty()) {
            return cutParts(to, parts, group);
        }
    }
    return cut(to, from, group);
}

// A part that the blade has left behind stays until the blade is ahead of it again.
bool Cutter::State::goesInParts(const Blade& to, const std::vector<RungNode>& from,
                                const GroupStroke& group) {
    return !group.heading.isZero(0) &&
           (group.isUneven || cut::isPartlyBehind(to, group.edgeLength, group.heading, from));
}

/// From the last part to the first: the nodes before it keep their places in the rung. Where one is
/// refused the whole blade goes on.
CutResult Cutter::State::cutParts(const Blade& to, const std::vector<cut::RungPart>& parts,
                                  GroupStroke& group) {
    CutResult sum = outcome(CutOutcome::air);
    int staying = cut::sizeOf(group.rung);
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        CutResult result = outcome(CutOutcome::refused);
        if (!findStep([&] { return climb(to, *part, group, result); })) {
            tie(group);
            std::vector<RungNode> from = group.rung;
            cut::reparametrize(to, h, from);
            addTo(sum, cut(to, from, group));
            return sum;
        }
        addTo(sum, result);
        staying -= part->count;
    }
    moveOn(to, sum, group);
    sum.statistics.cutPieces = std::min(sum.statistics.cutPieces, 1);
    group.isUneven = staying > 0;
    if (!group.isUneven && isInAir(group.rung)) {
        setRung({group.rung.front(), group.rung.back()}, group);  // without where it crossed
    }
    return sum;
}

cut::BroadPhase Cutter::State::findCandidates(const Blade& to, const GroupStroke& group,
                                              const std::vector<RungNode>& from) {
    std::vector<Vec3> points{to.a, to.b};
    for (const RungNode& node : from) {
        points.push_back(node.position);
    }
    return {mesh,
            findTriangles(),
            to,
            points,
            margin(group.edgeLength),
            kBinSize * group.edgeLength,
            [this, number = group.number](int t) {
                return groupOfVertex(mesh.triangle(t)[0]) == number;
            },
            {settings.search, &searchWork}};
}

// Nothing is committed until one attempt succeeds.
CutResult Cutter::State::cut(const Blade& to, const std::vector<RungNode>& from,
                             GroupStroke& group) {
    CutResult result = outcome(CutOutcome::refused);
    const cut::RungPart whole{from, {}, 0, cut::sizeOf(group.rung)};
    if (findStep(
            [&] { return climb(to, whole, group, result) || resume(to, from, group, result); })) {
        moveOn(to, result, group);
        group.isUneven = false;
        return result;
    }
    result.statistics.refusedPieces = 1;
    countRefusal(to, group);
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

// The retry ladder: with older slits along the blade seen open, then with all as they are; a
// transit that once had to do without stays so.
bool Cutter::State::climb(const Blade& to, const cut::RungPart& part, GroupStroke& group,
                          CutResult& result) {
    const cut::BroadPhase candidates = findCandidates(to, group, part.rung);
    if (group.opensSlits && climbOpened(to, part, candidates, group, result)) {
        return true;
    }
    return !group.opensSlits &&
           tryLevels(to, part, candidates, kNoOpening, cut::attemptCount(), group, result);
}

// A blade that leaves an older slit at an angle may meet walls again that it saw open before: they
// are then seen open farther.
bool Cutter::State::climbOpened(const Blade& to, const cut::RungPart& part,
                                const cut::BroadPhase& candidates, GroupStroke& group,
                                CutResult& result) {
    const auto opened = [&](double opening, bool takesSeamsAlong) {
        return cut::SlitOpening(
            mesh, candidates,
            {part.rung, to, group.edgeLength, stroke, group.firstVertexOfTransit, group.onSeams,
             group.sides, opening, takesSeamsAlong});
    };
    const cut::SlitOpening first = opened(kOpenings.front(), false);
    if (tryLevels(to, part, candidates, first, cut::attemptCount(), group, result)) {
        return true;
    }
    if (first.empty()) {
        return false;
    }
    const std::map<int, Vec3> sides = group.sides;
    for (const double opening : kOpenings) {
        if (tryLevels(to, part, candidates, opened(opening, true), kAttemptsOfOpening, group,
                      result)) {
            return true;
        }
        group.sides = sides;
    }
    group.opensSlits = false;
    return false;
}

bool Cutter::State::tryLevels(const Blade& to, const cut::RungPart& part,
                              const cut::BroadPhase& candidates, const cut::SlitOpening& opening,
                              int levels, GroupStroke& group, CutResult& result) {
    cut::RungPart clear = part;
    cut::AirTies ties;
    cut::clearAirEdges(
        mesh, candidates, opening, to, group.edgeLength,
        [&]() -> const cut::AirTies& {
            makeWaitingTies(group);
            return ties = group.airTies.part(part.first, part.first + part.count - 1,
                                             part.beforeFirst);
        },
        clear.rung);
    for (int i = 0; i < levels; ++i) {
        if (attempt(to, clear, candidates, opening, i, group, result)) {
            return true;
        }
    }
    return false;
}

// What a moving body does not let through now it often does in the next step.
bool Cutter::State::mayWait(const GroupStroke& group) const {
    return group.refusedInARow + 1 < kRefusalsBeforeDetach &&
           std::ranges::any_of(group.rung, [&](const RungNode& node) {
               return node.vertex >= 0 && !mesh.velocity(node.vertex).isZero(0);
           });
}

// Lets go of the front, and cuts anew across the walls behind it: close beside them where the
// body surely parts so, and then on to the blade; otherwise steeply, and if need be without proof.
bool Cutter::State::resume(const Blade& to, const std::vector<RungNode>& from, GroupStroke& group,
                           CutResult& result) {
    if (mayWait(group)) {
        return false;
    }
    const auto startsBy = [&](const std::vector<cut::Resumption>& ways) {
        return std::ranges::any_of(
            ways, [&](const cut::Resumption& way) { return startAnew(way, group, result); });
    };
    piecesToCross = cut::piecesOfFront(from, pieces.ofVertex());
    const bool mayProve = !piecesToCross.empty();
    if (mayProve && startsBy(cut::crossings(from, to, std::min(h, group.edgeLength)))) {
        piecesToCross.clear();
        goOn(to, group, result);
        return true;
    }
    const std::vector<cut::Resumption> steep = cut::resumptions(from, to, group.edgeLength);
    const bool crosses = mayProve && startsBy(steep);
    piecesToCross.clear();
    return crosses || startsBy(steep);
}

bool Cutter::State::startAnew(const cut::Resumption& way, GroupStroke& group, CutResult& result) {
    GroupStroke anew = group;
    startTransit(anew);
    cut::RungPart start{way.rung, {}, 0, cut::sizeOf(anew.rung)};
    cut::reparametrize(way.blade, h, start.rung);
    const cut::BroadPhase candidates = findCandidates(way.blade, anew, start.rung);
    for (int i = 0; i < kAttemptsOfResumption; ++i) {
        if (attempt(way.blade, start, candidates, kNoOpening, i, anew, result)) {
            group = std::move(anew);
            group.opensSlits = false;
            result.statistics.resumed = 1;
            return true;
        }
    }
    return false;
}

// What can't be done now waits for the next step.
void Cutter::State::goOn(const Blade& to, GroupStroke& group, CutResult& result) {
    tie(group);
    cut::RungPart whole{group.rung, {}, 0, cut::sizeOf(group.rung)};
    cut::reparametrize(to, h, whole.rung);
    CutResult more = outcome(CutOutcome::refused);
    if (climb(to, whole, group, more)) {
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
                            int level, GroupStroke& group, CutResult& result) {
    const std::uint64_t retrySeed =
        settings.seed * 7 + static_cast<std::uint64_t>(mesh.triangleSlots());
    const double edge = group.edgeLength;
    const double scale = h / edge;  // shares that stay shares of h
    Bounds bodyBox = findTriangles().bounds();
    bodyBox.widen(kBroadPhaseMargin * edge);  // predicates may see vertices that far outside
    const cut::StepInput in{
        .mesh = mesh,
        .broadPhase = candidates,
        .pieceOfVertex = pieces.ofVertex(),
        .surface = surface,
        .opening = opening,
        .rung = part.rung,
        .blade = to,
        .span = part.span,
        .h = edge,
        .offset = settings.offset * scale,
        .edgeLengths = *edgeLengths,
        .seed = settings.seed,
        .stroke = stroke,
        .transit = group.transit,
        .firstVertexOfTransit = group.firstVertexOfTransit,
        .attempt = cut::attemptAt(level, settings.tolerance * scale, retrySeed),
        .body = bodyBox,
        .atRest = atRest,
    };
    const int tries = result.statistics.tries + 1;
    const std::string reason = result.reason;
    result.statistics.tries = tries;
    try {
        const cut::PlannedStep step = cut::planStep(in);
        requireCrossing(step);
        requireVolume(step.plan);
        requireMirrors(step.plan, edge);
        result = accept(to, step, part, group);
        result.statistics.tries = tries;
        result.reason = reason;
        return true;
    } catch (const cut::StepFailure& failure) {
        result.reason = failure.reason;
        return false;
    }
}

CutResult Cutter::State::accept(const Blade& to, const cut::PlannedStep& step,
                                const cut::RungPart& part, GroupStroke& group) {
    group.refusedInARow = 0;
    if (step.air) {
        setRung(cut::replaced(group.rung, part, {step.air->endA, step.air->endB}), group);
        return outcome(CutOutcome::air);
    }
    if (settings.cleanUp && !cleanup) {
        cleanup.emplace(mesh, *edgeLengths);
    }
    cut::CommitResult committed =
        cut::commit(mesh, step.plan, group.edgeLength, stroke, cut::stayingFront(group.rung, part));
    const std::vector<int> changed = changedTriangles(committed.delta);
    follow(changed, group.number);
    surface.follow(changed, 0);
    madeWalls = true;
    group.onSeams.insert(committed.onSeams.begin(), committed.onSeams.end());
    CutResult result = outcome(CutOutcome::cut);
    result.delta = std::move(committed.delta);
    result.statistics.cutPieces = 1;
    result.statistics.touchedTriangles = cut::sizeOf(step.plan.subdivision.replaced);
    result.statistics.wallTriangles = step.wallTriangles;
    result.statistics.splitVertices = committed.splitVertices;
    result.statistics.patterns = step.plan.subdivision.patterns;
    result.statistics.seeds = step.seeds;
    result.statistics.volumeChange = step.plan.volumeChange;
    const Vec3 way = cut::advanceOf(to, group.edgeLength, part.rung, committed.rung);
    group.heading = way.isZero(0) ? group.heading : way;
    std::vector<RungNode> next = cut::replaced(group.rung, part, committed.rung);
    if (isInAir(next)) {
        group.heading = Vec3::Zero();
        startTransit(group);
    }
    group.rung = std::move(next);  // tied once all of the step is done
    return result;
}

void Cutter::State::moveOn(const Blade& to, const CutResult& result, GroupStroke& group) {
    const Blade from = std::exchange(group.blade, to);
    if (result.outcome == CutOutcome::cut) {
        group.lastAdvance = 0.5 * (to.a - from.a + to.b - from.b);
    }
}

void Cutter::State::countRefusal(const Blade& to, GroupStroke& group) {
    if (++group.refusedInARow >= kRefusalsBeforeDetach) {
        group.refusedInARow = 0;
        placeRung(to, group);
    }
}

}  // namespace kerf
