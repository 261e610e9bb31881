// From top to bottom: the blade has moved; in which strips the group goes on; how a valid try is
// found for one strip; one try; what else there is to a step.

#include "sim/cut/stroke/group_step.h"

#include "sim/cut/blade.h"
#include "sim/cut/commit/commit.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/plan/air_edges.h"
#include "sim/cut/plan/input/slit_opening.h"
#include "sim/cut/plan/plan.h"
#include "sim/cut/stroke/group_rung.h"
#include "sim/cut/stroke/group_stroke.h"
#include "sim/cut/stroke/ladder.h"
#include "sim/cut/stroke/rung_parts.h"

namespace kerf::cut {

namespace {

// After so many refused steps in a row the front is let go; it stays as a slit.
constexpr int kRefusalsBeforeDetach = 3;
// Sliding along the axis in the air by more than this many times the advance takes the rung along.
constexpr double kAxialSlide = 4;
constexpr double kBinSize = 1.0;
// Of the edge length: so near to its own walls a blade is there.
constexpr double kAtOwnStart = 0.25;
// A stroke that ends there is taken to so far ahead.
constexpr double kPastOwnStart = 0.3;
// Of the body at rest: a step that would change its volume by more is not done. The bar is 1e-9 for
// all pieces together.
constexpr double kMostVolumeChange = 5e-10;
// How far older slits are seen open (OpeningInput): at first, and together with what the transit
// has divided of them.
constexpr double kOpening = 0.1;
constexpr double kFartherOpening = 0.2;
// Of a step, in edges: its row may be one triangle high where edges grow, and the walls beside the
// front are not past (OwnPast).
constexpr double kMostWayOfRow = 1.5;
constexpr int kFirstLevels = 2;  // of the ladder: with the body as it is
const SlitOpening kNoOpening;

CutResult resultOf(const PlannedStep& step, CommitResult committed) {
    CutResult result = outcome(CutOutcome::cut);
    result.delta = std::move(committed.delta);
    result.statistics.cutPieces = 1;
    result.statistics.touchedTriangles = sizeOf(step.plan.subdivision.replaced);
    result.statistics.wallTriangles = step.wallTriangles;
    result.statistics.splitVertices = committed.splitVertices;
    result.statistics.patterns = step.plan.subdivision.patterns;
    result.statistics.seeds = step.seeds;
    result.statistics.swept = step.swept;
    result.statistics.volumeChange = step.plan.volumeChange;
    return result;
}

/// Nothing for a rung in the air.
std::optional<Vec3> middleOfFront(const std::vector<RungNode>& rung) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const RungNode& node : rung) {
        sum += node.vertex >= 0 ? node.position : Vec3(Vec3::Zero());
        count += node.vertex >= 0 ? 1 : 0;
    }
    return count > 0 ? std::optional<Vec3>(sum / count) : std::nullopt;
}

/// A step of the blade through one group of pieces, made for that step alone.
class GroupStep {
  public:
    GroupStep(CutBody& body, Stroke& stroke, GroupStroke& group)
        : body_(body), stroke_(stroke), group_(group) {}

    CutResult take(Gate gate) {
        if (isAtOwnStart()) {
            if (gate != Gate::flush) {
                return outcome(CutOutcome::waiting);
            }
            goPastOwnStart();
        }
        std::vector<RungNode> from = group_.rung;
        const double growth = gate == Gate::flush ? 1 : rowGrowth(body_.settings, group_);
        const double least = body_.gateLength(gate, group_.edgeLength) * growth;
        const BladeAdvance motion = reparametrize(to_, body_.h(), from);
        if (goesInParts(from)) {
            return cutAhead(from, least);
        }
        if (motion.advance < std::max(least, kStandingStill * body_.h())) {
            const bool slides = motion.axial > kAxialSlide * motion.advance && motion.axial > least;
            if (!motion.anyAttached && slides) {
                rung_.slide(to_, from);
            }
            return outcome(CutOutcome::waiting);
        }
        if (isWithdrawing(body_.mesh, to_, body_.h(), group_.lastAdvance, from)) {
            return outcome(CutOutcome::withdrawing);
        }
        const std::vector<RungPart> parts =
            isInAir(from) ? partsInAir(to_, group_.edgeLength, from) : std::vector<RungPart>{};
        return parts.empty() ? cutWhole(from) : cutParts(parts);
    }

  private:
    /// Whether older walls must stay mirrored. No step is refused for their sake alone.
    enum class Mirrors {
        wanted,  ///< a try fails where they do not
        missed,  ///< some try has failed for them alone
        waived,  ///< tries do not look at them
    };
    /// The tries of a step so far.
    struct Tries {
        int count = 0;
        std::string reason;  ///< why the last one that failed did
    };
    /// What a try goes by besides the group.
    struct Try {
        const Blade& to;
        const RungPart& part;
        const BroadPhase& candidates;
        const SlitOpening& opening;
        Level level = Level::asIs;
        std::set<int> mustCross{};  ///< pieces in which it must cross the stroke's walls
    };

    /// Whether the blade has come round to where its walls began: it lies along most of that. A
    /// step that ended there would lead part of the front past it and leave the rest before it.
    bool isAtOwnStart() const {
        const std::span<const int> start = group_.past.startVertices();
        body_.mesh.bring(start);
        const auto near = std::ranges::count_if(start, [&](int v) { return isAtBlade(v); });
        return 2 * near > sizeOf(start);
    }

    /// Whether walls of the same transit that count as old are at the blade.
    bool isInOwnSlit() const {
        const VertexRange& past = group_.past.vertices();
        std::vector<int> vertices(std::max(0, past.end - past.first));
        std::iota(vertices.begin(), vertices.end(), past.first);
        body_.mesh.bring(vertices);
        return std::ranges::any_of(vertices, [&](int v) { return isAtBlade(v); });
    }

    bool isAtBlade(int v) const {
        return body_.mesh.outgoing(v) >= 0 &&
               across(to_, body_.mesh.position(v) - to_.a).norm() < kAtOwnStart * group_.edgeLength;
    }

    /// Straight ahead.
    void goPastOwnStart() {
        const Vec3 way =
            across(to_, group_.heading).stableNormalized() * (kPastOwnStart * group_.edgeLength);
        to_ = {to_.a + way, to_.b + way};
    }

    /// Whether parts of the rung go on by themselves. A part that the blade has left behind stays
    /// until the blade is ahead of it again.
    bool goesInParts(const std::vector<RungNode>& from) const {
        return !group_.heading.isZero(0) &&
               (group_.isUneven || isPartlyBehind(to_, group_.edgeLength, group_.heading, from));
    }

    CutResult cutAhead(const std::vector<RungNode>& from, double least) {
        const CutOutcome otherwise =
            isWithdrawing(body_.mesh, to_, body_.h(), group_.lastAdvance, from)
                ? CutOutcome::withdrawing
                : CutOutcome::waiting;
        const std::vector<RungPart> parts =
            partsAhead(to_, group_.edgeLength, least, group_.heading, from);
        return parts.empty() ? outcome(otherwise) : cutParts(parts);
    }

    /// From the last part to the first: the nodes before it keep their places in the rung. Where
    /// one is refused the whole blade goes on.
    CutResult cutParts(const std::vector<RungPart>& parts) {
        CutResult sum = outcome(CutOutcome::air);
        int staying = sizeOf(group_.rung);
        for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
            const std::optional<CutResult> result = find(*part, false);
            if (!result) {
                rung_.tie();
                addTo(sum, cutWhole(wholeRung().rung));
                return sum;
            }
            addTo(sum, *result);
            staying -= part->count;
        }
        moveOn(sum);
        sum.statistics.cutPieces = std::min(sum.statistics.cutPieces, 1);
        group_.isUneven = staying > 0;
        if (!group_.isUneven && isInAir(group_.rung)) {
            // Without where it crossed.
            rung_.set({group_.rung.front(), group_.rung.back()});
        }
        return sum;
    }

    CutResult cutWhole(const std::vector<RungNode>& from) {
        if (std::optional<CutResult> result =
                find({from, {}, 0, sizeOf(group_.rung)}, stroke_.mayResume)) {
            moveOn(*result);
            group_.isUneven = false;
            return std::move(*result);
        }
        if (isInOwnSlit()) {  // What lies ahead was cut, so the front ends here.
            rung_.place(to_);
            return outcome(CutOutcome::waiting);
        }
        countRefusal();
        CutResult refused = outcome(CutOutcome::refused);
        refused.statistics.refusedPieces = 1;
        refused.statistics.tries = tries_.count;
        refused.reason = tries_.reason;
        return refused;
    }

    /// First with walls mirrored, and without where that alone is in the way. Nothing is committed
    /// until one try succeeds.
    std::optional<CutResult> find(const RungPart& part, bool mayResume) {
        tries_ = {};
        for (mirrors_ = Mirrors::wanted;; mirrors_ = Mirrors::waived) {
            std::optional<CutResult> result = climb(part);
            if (!result && mayResume) {
                result = resume(part.rung);
            }
            if (result || mirrors_ != Mirrors::missed) {
                return result;
            }
        }
    }

    /// The retry ladder: with older slits along the blade seen open, then with all as they are; a
    /// transit that once had to do without stays so. A blade that leaves an older slit at an angle
    /// may meet walls again that it saw open before: they are then seen open farther.
    std::optional<CutResult> climb(const RungPart& part) {
        const BroadPhase candidates = findCandidates(to_, part.rung);
        const auto opened = [&](double opening, bool takesSeamsAlong) {
            return SlitOpening(body_.mesh, candidates,
                               {.rung = part.rung,
                                .blade = to_,
                                .h = group_.edgeLength,
                                .stroke = stroke_.number,
                                .firstVertexOfTransit = group_.firstVertexOfTransit,
                                .onSeams = group_.onSeams,
                                .sides = group_.sides,
                                .opening = opening,
                                .takesSeamsAlong = takesSeamsAlong,
                                .past = group_.past.vertices()});
        };
        if (group_.opensSlits) {
            const SlitOpening first = opened(kOpening, false);
            std::optional<CutResult> result = tryLevels(part, candidates, first, kLevels);
            if (result || first.empty()) {
                return result;
            }
            const std::map<int, Vec3> sides = group_.sides;
            result = tryLevels(part, candidates, opened(kFartherOpening, true), kFirstLevels);
            if (result) {
                return result;
            }
            group_.sides = sides;
            group_.opensSlits = false;
        }
        return tryLevels(part, candidates, kNoOpening, kLevels);
    }

    std::optional<CutResult> tryLevels(const RungPart& part, const BroadPhase& candidates,
                                       const SlitOpening& opening, int levels) {
        RungPart clear = part;
        AirTies ties;
        clearAirEdges(
            body_.mesh, candidates, opening, to_, group_.edgeLength,
            [&]() -> const AirTies& {
                rung_.makeWaitingTies();
                return ties = group_.airTies.part(part.first, part.first + part.count - 1,
                                                  part.beforeFirst);
            },
            clear.rung);
        std::optional<CutResult> result;
        for (int i = group_.leftPlane ? 1 : 0; i < levels && !result; ++i) {
            result = attempt({.to = to_,
                              .part = clear,
                              .candidates = candidates,
                              .opening = opening,
                              .level = static_cast<Level>(i)});
        }
        return result;
    }

    /// Lets go of the front, and cuts anew across the walls behind it: where the body surely parts
    /// so, on to the blade; otherwise without proof, and the rest waits for the next step. In its
    /// own slit nothing is left that would be worth a slit beside it.
    std::optional<CutResult> resume(const std::vector<RungNode>& from) {
        if (mayWait()) {
            return std::nullopt;
        }
        const std::set<int> pieces = piecesOfFront(from, body_.pieces.labels().ofVertex());
        const double edge = group_.edgeLength;
        if (!pieces.empty()) {
            if (auto start = startAnew(resumptions(from, to_, std::min(body_.h(), edge)), pieces)) {
                return goOn(std::move(*start));
            }
        }
        return isInOwnSlit() ? std::nullopt : startAnew(resumptions(from, to_, edge), {});
    }

    std::optional<CutResult> startAnew(const std::vector<Resumption>& ways,
                                       const std::set<int>& mustCross) {
        for (const Resumption& way : ways) {
            GroupStroke before = group_;
            rung_.startTransit();
            RungPart start{way.rung, {}, 0, sizeOf(group_.rung)};
            for (RungNode& node : start.rung) {
                node.position += rung_.leastOffsetAt(node.s);
            }
            reparametrize(way.blade, body_.h(), start.rung);
            const BroadPhase candidates = findCandidates(way.blade, start.rung);
            if (auto result =
                    attempt({way.blade, start, candidates, kNoOpening, Level::beside, mustCross})) {
                group_.opensSlits = false;
                result->statistics.resumed = 1;
                return result;
            }
            group_ = std::move(before);
        }
        return std::nullopt;
    }

    /// On to the blade after a start close beside the old walls. What can't be done now waits for
    /// the next step.
    CutResult goOn(CutResult start) {
        rung_.tie();
        tries_ = {};
        if (const std::optional<CutResult> more = climb(wholeRung())) {
            addTo(start, *more);
            start.statistics.cutPieces = 1;
        }
        return start;
    }

    std::optional<CutResult> attempt(const Try& one) {
        if (isLeftOut(one.level)) {
            return std::nullopt;
        }
        ++tries_.count;
        try {
            const PlannedStep step = planStep(inputOf(one));
            require(one, step);
            CutResult result = accept(one, step);
            group_.leftPlane |= one.level != Level::asIs;
            result.statistics.tries = tries_.count;
            result.reason = tries_.reason;
            return result;
        } catch (const StepFailure& failure) {
            tries_.reason = failure.reason;
            return std::nullopt;
        }
    }

    StepInput inputOf(const Try& one) {
        const CutSettings& settings = body_.settings;
        const double edge = group_.edgeLength;
        const double scale = body_.h() / edge;  // shares that stay shares of h
        Bounds bodyBox = body_.triangles.finder().bounds();
        bodyBox.widen(kBroadPhaseMargin * edge);  // predicates may see vertices that far outside
        return {
            .mesh = body_.mesh,
            .broadPhase = one.candidates,
            .pieceOfVertex = body_.pieces.labels().ofVertex(),
            .surface = body_.surface,
            .opening = one.opening,
            .rung = one.part.rung,
            .blade = one.to,
            .span = one.part.span,
            .h = edge,
            .offset = settings.offset * scale,
            .edgeLengths = *body_.edgeLengths,
            .grading = {settings.wallCoarsening},
            .seed = settings.seed,
            .stroke = stroke_.number,
            .transit = group_.transit,
            .firstVertexOfTransit =
                one.opening.opensPast() ? group_.past.vertices().end : group_.firstVertexOfTransit,
            .attempt = attemptAt(one.level, settings.tolerance * scale),
            .body = bodyBox,
            .atRest = body_.atRest,
            .flushSides = group_.flushSides,
        };
    }

    /// Carries out a planned step.
    CutResult accept(const Try& one, const PlannedStep& step) {
        group_.refusedInARow = 0;
        if (step.air) {
            rung_.set(replaced(group_.rung, one.part,
                               {rung_.nodeInAir(one.to, one.part.span.from),
                                rung_.nodeInAir(one.to, one.part.span.to)}));
            return outcome(CutOutcome::air);
        }
        if (body_.settings.cleanUp && !stroke_.cleanup) {
            stroke_.cleanup.emplace(body_.mesh, *body_.edgeLengths);
        }
        const int firstVertex = body_.mesh.vertexCount();
        CommitResult committed = commit(body_.mesh, step.plan, group_.edgeLength, stroke_.number,
                                        stayingFront(group_.rung, one.part));
        const std::vector<int> changed = changedTriangles(committed.delta);
        body_.follow({.triangles = changed, .groupOfNewPieces = group_.number});
        stroke_.noteWalls();
        group_.onSeams.insert(committed.onSeams.begin(), committed.onSeams.end());
        const Vec3 way = advanceOf(one.to, group_.edgeLength, one.part.rung, committed.rung);
        group_.heading = way.isZero(0) ? group_.heading : way;
        std::vector<RungNode> next = replaced(group_.rung, one.part, committed.rung);
        followPast(one, committed.rung, firstVertex);
        if (isInAir(next)) {
            endTransit(one.opening.opensPast());
        }
        group_.rung = std::move(next);  // tied once all of the step is done
        return resultOf(step, std::move(committed));
    }

    /// Notes what of the stroke's walls lies so far behind that the blade may come round to it.
    /// `first`: the first vertex that the step made.
    void followPast(const Try& one, const std::vector<RungNode>& next, int first) {
        if (isInAir(one.part.rung)) {
            group_.past.begin(endsOfSlit(first, next));
        }
        const double most = body_.settings.wallCoarsening > 1 ? kMostWayOfRow : 1e300;
        group_.past.goOn(std::min(most, wayOf(one.part, next)), first);
    }

    /// A transit ends: in the air, or in the stroke's own slit.
    void endTransit(bool inOwnSlit) {
        OwnPast past = group_.past;
        group_.heading = Vec3::Zero();
        rung_.startTransit();
        if (inOwnSlit) {
            past.closeUp(body_.mesh.vertexCount());
            group_.past = std::move(past);
        }
    }

    /// Vertices from `first` on where the walls of the stroke end in the body, but for its front.
    std::vector<int> endsOfSlit(int first, const std::vector<RungNode>& front) const {
        std::vector<int> ends;
        for (int v = first; v < body_.mesh.vertexCount(); ++v) {
            if (isEndOfSlit(body_.mesh, v, stroke_.number) &&
                std::ranges::find(front, v, &RungNode::vertex) == front.end()) {
                ends.push_back(v);
            }
        }
        return ends;
    }

    /// How far a part of the front has gone on, as a share of the edge length, times its share of
    /// the front.
    double wayOf(const RungPart& part, const std::vector<RungNode>& next) const {
        const std::optional<Vec3> from = middleOfFront(part.rung);
        const std::optional<Vec3> to = middleOfFront(next);
        const double share = static_cast<double>(part.count) / sizeOf(group_.rung);
        return from && to ? share * (*to - *from).norm() / group_.edgeLength : 0.0;
    }

    /// Throws StepFailure where a step that could be planned is not to be done.
    void require(const Try& one, const PlannedStep& step) {
        const StepPlan& plan = step.plan;
        if (!one.mustCross.empty() &&
            (step.air || leavesBridge(body_.mesh, stroke_.number, one.mustCross, plan))) {
            throw StepFailure{"the new walls do not cross the old ones"};
        }
        const double most = kMostVolumeChange * stroke_.start.restVolume;
        if (std::fabs(plan.volumeChange) > most || std::fabs(plan.restVolumeChange) > most) {
            throw StepFailure{"the step would change the volume"};
        }
        if (mirrors_ != Mirrors::waived &&
            !keepsMirrors(body_.mesh, plan, kCloseNoise * group_.edgeLength)) {
            mirrors_ = Mirrors::missed;
            throw StepFailure{"the two sides of a wall would divide differently"};
        }
    }

    /// The rung as it is, measured along the blade.
    RungPart wholeRung() const {
        RungPart whole{group_.rung, {}, 0, sizeOf(group_.rung)};
        reparametrize(to_, body_.h(), whole.rung);
        return whole;
    }

    /// The triangles of the group near the way from a rung to a blade.
    BroadPhase findCandidates(const Blade& to, const std::vector<RungNode>& from) {
        std::vector<Vec3> points{to.a, to.b};
        for (const RungNode& node : from) {
            points.push_back(node.position);
        }
        return {body_.mesh,
                body_.triangles.finder(),
                to,
                points,
                body_.margin(group_.edgeLength),
                kBinSize * group_.edgeLength,
                [this, number = group_.number](int t) {
                    return body_.pieces.groupOf(body_.mesh.triangle(t)[0]) == number;
                },
                {body_.settings.search, &body_.searchWork}};
    }

    /// Whether a refused step may wait for the next one before the front is let go: what a moving
    /// body does not let through now it often does in the next step.
    bool mayWait() const {
        return group_.refusedInARow + 1 < kRefusalsBeforeDetach &&
               std::ranges::any_of(group_.rung, [&](const RungNode& node) {
                   return node.vertex >= 0 && !body_.mesh.velocity(node.vertex).isZero(0);
               });
    }

    /// Remembers the blade of a step that was taken.
    void moveOn(const CutResult& result) {
        const Blade from = std::exchange(group_.blade, to_);
        if (result.outcome == CutOutcome::cut) {
            group_.lastAdvance = 0.5 * (to_.a - from.a + to_.b - from.b);
        }
    }

    /// After several the front is let go.
    void countRefusal() {
        if (++group_.refusedInARow >= kRefusalsBeforeDetach) {
            group_.refusedInARow = 0;
            rung_.place(to_);
        }
    }

    CutBody& body_;
    Stroke& stroke_;
    GroupStroke& group_;
    GroupRung rung_{body_, stroke_, group_};
    Blade to_ = stroke_.blade;
    Tries tries_;
    Mirrors mirrors_ = Mirrors::wanted;
};

}  // namespace

CutResult takeStep(CutBody& body, Stroke& stroke, GroupStroke& group, Gate gate) {
    return GroupStep(body, stroke, group).take(gate);
}

}  // namespace kerf::cut
