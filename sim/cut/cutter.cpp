#include "sim/cut/cutter.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "sim/cut/air_edges.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/ladder.h"
#include "sim/cut/plan.h"
#include "sim/cut/skin_map.h"
#include "sim/cut/sweep.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf {

namespace {

// On coarse models walls are finer than the skin: about twelve of their edges span the body.
constexpr double kEdgesPerDiagonal = 12;
// After so many refused steps in a row the front is let go; it stays as a slit.
constexpr int kRefusalsBeforeDetach = 3;
// What `finish` sweeps although it is below the gate (share of h), and how many times the blade's
// offset it is at least.
constexpr double kLeastFlush = 0.01;
constexpr double kLeastFlushOffsets = 4;
// Below this share of h the blade stands still.
constexpr double kStandingStill = 1e-9;
// Sliding along the axis in the air by more than this many times the advance restarts the rung.
constexpr double kAxialSlide = 4;
// Largest distance (share of h) from the sweep at which a triangle can matter: predicates see
// vertices elsewhere, and the rung is led around skin that moved across it.
constexpr double kBroadPhaseMargin = 3;
constexpr double kBinSize = 1.0;
// Keeps passes apart from those of strokes that an earlier cutter made.
constexpr int kPassesPerStroke = 1000;

double defaultWallEdge(const SurfaceMesh& mesh) {
    double sum = 0;
    int count = 0;
    Bounds bounds;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t) || mesh.kind(t) != SurfaceKind::skin) {
            continue;
        }
        for (int e = 0; e < 3; ++e) {
            const Vec3& p = mesh.restPosition(mesh.origin(3 * t + e));
            sum += (mesh.restPosition(mesh.target(3 * t + e)) - p).norm();
            bounds.add(p);
            ++count;
        }
    }
    return count == 0 ? 1.0 : std::min(sum / count, bounds.diagonal() / kEdgesPerDiagonal);
}

int strokesSoFar(const SurfaceMesh& mesh) {
    int last = -1;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        last = std::max(last, mesh.wallLabel(t));
    }
    return last < 0 ? 0 : last / 2 + 1;
}

bool isInAir(const std::vector<RungNode>& rung) {
    return std::all_of(rung.begin(), rung.end(), [](const RungNode& n) { return n.vertex < 0; });
}

CutResult outcome(CutOutcome what) {
    CutResult result;
    result.outcome = what;
    return result;
}

}  // namespace

struct Cutter::State {
    SurfaceMesh& mesh;
    CutSettings settings;
    double h = 0;
    int stroke = 0;
    int pass = 0;  ///< goes up each time the blade starts from the air
    bool inStroke = false;
    Blade blade{};  ///< the last one given
    std::vector<RungNode> rung{};
    bool madeWalls = false;           ///< in this stroke
    std::vector<int> skinVertices{};  ///< of this stroke
    std::vector<int> skinSamples{};   ///< those of them that the map to the rest shape uses
    int refusedInARow = 0;
    PieceLabels pieces{mesh};
    TriangleTree tree{mesh};
    std::optional<double> moved{};  ///< how far vertices moved at most since the last step [m]

    void placeRung(const Blade& at);
    double leastFlush() const {
        return std::max(kLeastFlush, kLeastFlushOffsets * settings.offset) * h;
    }
    CutResult sweep(const Blade& to, double gate);
    CutResult cut(const Blade& to, std::vector<RungNode> from);
    CutResult accept(const cut::PlannedStep& step);
    void countRefusal(const Blade& to);
    cut::BroadPhase findCandidates(const Blade& to, const std::vector<RungNode>& from);
    void noteMotion();
    void sampleSkin();
    void follow(const CutDelta& delta);
};

// The rung carries the offset of the stroke from the start: otherwise a blade that is put down
// exactly on a vertex would stay there in every retry.
void Cutter::State::placeRung(const Blade& at) {
    ++pass;
    rung = {{at.a, 0, -1, false}, {at.b, 1, -1, false}};
    const std::vector<int> noPieces;
    const cut::BroadPhase nothing;
    const cut::StepInput in{mesh,          nothing, noPieces, rung, at, h, settings.offset,
                            settings.seed, stroke,  pass,     {}};
    rung[0].position += cut::bladeOffset(in, 0);
    rung[1].position += cut::bladeOffset(in, 1);
}

CutResult Cutter::State::sweep(const Blade& to, double gate) {
    if ((to.b - to.a).norm() <= kStandingStill * h) {
        return outcome(CutOutcome::waiting);
    }
    std::vector<RungNode> from = rung;
    cut::followMesh(mesh, from);
    const cut::SweepMotion motion = cut::reparametrize(to, h, from);
    if (motion.advance < std::max(gate, kStandingStill * h)) {
        const bool slides = motion.axial > kAxialSlide * motion.advance && motion.axial > gate;
        if (!motion.anyAttached && slides) {
            placeRung(to);
        }
        return outcome(CutOutcome::waiting);
    }
    if (cut::isWithdrawing(mesh, to, h, from)) {
        return outcome(CutOutcome::withdrawing);
    }
    return cut(to, from);
}

cut::BroadPhase Cutter::State::findCandidates(const Blade& to, const std::vector<RungNode>& from) {
    std::vector<Vec3> points{to.a, to.b};
    for (const RungNode& node : from) {
        points.push_back(node.position);
    }
    const double widestOffset = cut::largestOffsetScale() * settings.offset;
    return {mesh, tree, to, points, (kBroadPhaseMargin + widestOffset) * h, kBinSize * h};
}

// Climbs the retry ladder: nothing is committed until one attempt succeeds.
CutResult Cutter::State::cut(const Blade& to, std::vector<RungNode> from) {
    const cut::BroadPhase candidates = findCandidates(to, from);
    cut::clearAirEdges(mesh, candidates, to, h, from);
    if (skinSamples.empty()) {
        sampleSkin();
    }
    const std::uint64_t retrySeed =
        settings.seed * 7 + static_cast<std::uint64_t>(mesh.triangleSlots());
    std::string reason;
    for (int i = 0; i < cut::attemptCount(); ++i) {
        const cut::StepInput in{mesh,
                                candidates,
                                pieces.ofVertex(),
                                from,
                                to,
                                h,
                                settings.offset,
                                settings.seed,
                                stroke,
                                pass,
                                cut::attemptAt(i, settings.tolerance, retrySeed)};
        try {
            CutResult result = accept(cut::planStep(in, skinSamples));
            result.statistics.tries = i + 1;
            result.reason = reason;
            return result;
        } catch (const cut::StepFailure& failure) {
            reason = failure.reason;
        }
    }
    CutResult result = outcome(CutOutcome::refused);
    result.statistics.tries = cut::attemptCount();
    result.reason = reason;
    countRefusal(to);
    return result;
}

CutResult Cutter::State::accept(const cut::PlannedStep& step) {
    refusedInARow = 0;
    if (step.air) {
        rung = {step.air->endA, step.air->endB};
        return outcome(CutOutcome::air);
    }
    cut::CommitResult committed = cut::commit(mesh, step.plan, h, stroke);
    follow(committed.delta);
    madeWalls = true;
    rung = std::move(committed.rung);
    pass += isInAir(rung);
    CutResult result = outcome(CutOutcome::cut);
    result.delta = std::move(committed.delta);
    result.statistics.touchedTriangles = cut::sizeOf(step.plan.subdivision.replaced);
    result.statistics.wallTriangles = step.wallTriangles;
    result.statistics.splitVertices = committed.splitVertices;
    result.statistics.patterns = step.plan.subdivision.patterns;
    result.statistics.volumeChange = step.plan.volumeChange;
    return result;
}

void Cutter::State::follow(const CutDelta& delta) {
    const std::vector<int> changed = changedTriangles(delta);
    tree.update(changed);
    if (pieces.update(mesh, changed).piecesChanged) {
        skinSamples.clear();
    }
}

// O(n): at the first cut of a stroke, and after one that took a piece off.
void Cutter::State::sampleSkin() {
    if (skinVertices.empty()) {
        skinVertices = cut::findSkinVertices(mesh);
    }
    skinSamples = cut::thinByPiece(skinVertices, pieces.ofVertex());
}

void Cutter::State::noteMotion() {
    if (moved) {
        tree.moved(*std::exchange(moved, std::nullopt));
    } else {
        tree.movedAnyhow();
    }
}

void Cutter::State::countRefusal(const Blade& to) {
    if (++refusedInARow >= kRefusalsBeforeDetach) {
        refusedInARow = 0;
        placeRung(to);
    }
}

Cutter::Cutter(SurfaceMesh& mesh, const CutSettings& settings)
    : state_(std::make_unique<State>(State{mesh, settings})) {
    state_->h = settings.wallEdgeLength > 0 ? settings.wallEdgeLength : defaultWallEdge(mesh);
    state_->stroke = strokesSoFar(mesh);
    state_->pass = kPassesPerStroke * state_->stroke;
}

Cutter::~Cutter() = default;
Cutter::Cutter(Cutter&&) noexcept = default;
Cutter& Cutter::operator=(Cutter&&) noexcept = default;

void Cutter::begin(const Blade& blade) {
    State& state = *state_;
    state.stroke += state.madeWalls;  // a stroke that only met air leaves its number to the next
    state.madeWalls = false;
    state.inStroke = true;
    state.blade = blade;
    state.refusedInARow = 0;
    state.skinVertices.clear();
    state.skinSamples.clear();
    state.placeRung(blade);
}

CutResult Cutter::advance(const Blade& blade) {
    assert(state_->inStroke);
    state_->blade = blade;
    state_->noteMotion();
    return state_->sweep(blade, state_->settings.gate * state_->h);
}

CutResult Cutter::finish() {
    State& state = *state_;
    assert(state.inStroke);
    state.noteMotion();
    CutResult result = state.sweep(state.blade, state.leastFlush());
    state.inStroke = false;
    state.rung.clear();
    return result;
}

void Cutter::boundMotion(double distance) {
    state_->moved = state_->moved.value_or(0) + distance;
}

bool Cutter::inStroke() const {
    return state_->inStroke;
}
const std::vector<RungNode>& Cutter::rung() const {
    return state_->rung;
}

}  // namespace kerf
