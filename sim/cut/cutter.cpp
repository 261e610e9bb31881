#include "sim/cut/cutter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "sim/cut/air_edges.h"
#include "sim/cut/air_ties.h"
#include "sim/cut/cleanup/cleanup.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/debris.h"
#include "sim/cut/ladder.h"
#include "sim/cut/piece_groups.h"
#include "sim/cut/plan.h"
#include "sim/cut/resume.h"
#include "sim/cut/strip.h"
#include "sim/cut/sweep.h"
#include "sim/cut/wall_edge.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf {

namespace {

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
// Boxes of a step's searches may be turned against the box that was foreseen, and lie aside of it.
constexpr double kRoomForReach = 1.6;
// Pieces whose copies lie farther apart (share of h) are swept apart.
constexpr double kParted = 1e-3;
// Of the body at rest: a step that would change its volume by more is not done. The bar is 1e-9 for
// all pieces together.
constexpr double kMostVolumeChange = 5e-10;
// Levels of the retry ladder that are tried for each way to go on after a refusal.
constexpr int kAttemptsOfResumption = 2;
const cut::SlitOpening kNoOpening;
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
    return count == 0 ? 1.0 : wallEdgeFor(sum / count, bounds.diagonal());
}

int strokesSoFar(const SurfaceMesh& mesh) {
    int last = -1;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        last = std::max(last, mesh.wallLabel(t));
    }
    return last < 0 ? 0 : last / 2 + 1;
}

double sumOfRestVolumes(const PieceLabels& pieces) {
    double sum = 0;
    for (const PieceContent& piece : pieces.pieces()) {
        sum += std::fabs(piece.restVolume);
    }
    return sum;
}

bool isInAir(const std::vector<RungNode>& rung) {
    return std::all_of(rung.begin(), rung.end(), [](const RungNode& n) { return n.vertex < 0; });
}

CutResult outcome(CutOutcome what) {
    CutResult result;
    result.outcome = what;
    return result;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

void addTo(CutDelta& sum, const CutDelta& part) {
    append(sum.removedTriangles, part.removedTriangles);
    append(sum.addedTriangles, part.addedTriangles);
    append(sum.changedTriangles, part.changedTriangles);
    append(sum.movedVertices, part.movedVertices);
    append(sum.deadVertices, part.deadVertices);
}

void addTo(CutStatistics& sum, const CutStatistics& part) {
    sum.cutPieces += part.cutPieces;
    sum.refusedPieces += part.refusedPieces;
    sum.resumed += part.resumed;
    sum.touchedTriangles += part.touchedTriangles;
    sum.wallTriangles += part.wallTriangles;
    sum.splitVertices += part.splitVertices;
    sum.tries = std::max(sum.tries, part.tries);
    kerf::addTo(sum.patterns, part.patterns);
    sum.seeds += part.seeds;
    sum.volumeChange += part.volumeChange;
}

/// One outcome for several pieces: the later one in the list of CutOutcome, but a cut before a
/// refusal, since it changed the mesh.
void addTo(CutResult& sum, const CutResult& part) {
    const bool first = part.outcome == CutOutcome::cut && sum.outcome != CutOutcome::cut;
    if (first) {
        sum.delta.firstNewVertex = part.delta.firstNewVertex;
    }
    if (first || (sum.outcome != CutOutcome::cut && part.outcome > sum.outcome)) {
        sum.outcome = part.outcome;
    }
    addTo(sum.delta, part.delta);
    addTo(sum.statistics, part.statistics);
    sum.reason = part.reason.empty() ? sum.reason : part.reason;
}

/// The blade's way through one group of pieces (groupPieces). Each waits and refuses for itself.
struct Sweep {
    int vertex = -1;  ///< some vertex of the group
    int group = -1;
    int pass = 0;  ///< goes up each time the blade starts from the air
    int firstVertexOfPass = 0;
    std::set<int> onSeams;      ///< vertices of the pass on walls of older ones
    bool opensSlits = true;     ///< sees older slits along its way open
    std::map<int, Vec3> sides;  ///< in which slits of earlier strokes open (SweepStep)
    int refusedInARow = 0;
    std::vector<RungNode> rung;
    cut::AirTies airTies;
    Blade blade;                      ///< at the rung
    Vec3 lastAdvance = Vec3::Zero();  ///< of the blade's middle in the last step that cut [m]
};

}  // namespace

struct Cutter::State {
    SurfaceMesh& mesh;
    CutSettings settings;
    double h = 0;
    int stroke = 0;
    int pass = 0;  ///< the last one of any sweep
    bool inStroke = false;
    Blade blade{};  ///< the last one given
    std::vector<Sweep> sweeps{};
    std::vector<RungNode> rung{};  ///< those of all sweeps, one after the other
    bool madeWalls = false;        ///< in this stroke
    PieceLabels pieces{mesh};
    TriangleFinder* finder = nullptr;    ///< null: the tree
    std::optional<TriangleTree> tree{};  ///< made when it is first asked
    std::optional<double> moved{};       ///< how far vertices moved at most since the last step [m]
    std::vector<int> groupOfPiece{};
    int firstTriangle = 0;  ///< slot from which on the stroke made triangles
    double restVolume = 0;  ///< of the body at the start of the stroke [m^3]
    cut::StrokeSurface surface{mesh};
    std::optional<cut::Cleanup> cleanup{};  ///< of this stroke, once it has cut

    double leastFlush() const {
        return std::max(kLeastFlush, kLeastFlushOffsets * settings.offset) * h;
    }
    void start(const Blade& at);
    CutResult sweepAll(const Blade& to, double gate);
    void noteMotion();
    TriangleFinder& findTriangles();
    double margin() const;
    void follow(const std::vector<int>& changed, int groupOfNewPieces);
    void followCleanUp(const std::vector<int>& changedBefore, const CutDelta& delta);
    void divideSweeps();
    std::vector<int> lowestVertices(std::set<int> groups) const;
    int groupOfVertex(int v) const;
    void joinRungs();
    void cleanUpBehindFront(CutResult& result);
    void cleanUpAtEnd(CutResult& result);
    void removeDebris(CutResult& result);
    void holdLivingVertices();
    void tieRungs();

    // Of one group.
    void startPass(Sweep& sweep);
    void placeRung(const Blade& at, Sweep& sweep);
    void setRung(std::vector<RungNode> next, Sweep& sweep);
    void tie(Sweep& sweep);
    CutResult advance(const Blade& to, double gate, Sweep& sweep);
    CutResult cut(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep);
    bool climb(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep, CutResult& result);
    bool resume(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep,
                CutResult& result);
    bool attempt(const Blade& to, const std::vector<RungNode>& from,
                 const cut::BroadPhase& candidates, const cut::SlitOpening& opening, int level,
                 Sweep& sweep, CutResult& result);
    void requireVolume(const cut::StepPlan& plan) const;
    CutResult accept(const cut::PlannedStep& step, Sweep& sweep);
    void keepOwnNodes(std::vector<RungNode> nodes, Sweep& sweep);
    static void moveOn(const Blade& to, const CutResult& result, Sweep& sweep);
    void countRefusal(const Blade& to, Sweep& sweep);
    cut::BroadPhase findCandidates(const Blade& to, const Sweep& sweep,
                                   const std::vector<RungNode>& from);
    /// Tells the triangles of the group that were there before the stroke, or divide such.
    std::function<bool(int)> isOuter(const Sweep& sweep) const;
};

void Cutter::State::start(const Blade& at) {
    blade = at;
    inStroke = true;
    stroke += madeWalls;  // a stroke that only met air leaves its number to the next
    madeWalls = false;
    firstTriangle = mesh.triangleSlots();
    surface.beginStroke();
    cleanup.reset();
    sweeps.clear();
    groupOfPiece = cut::groupPieces(mesh, pieces, kParted * h, {});
    restVolume = sumOfRestVolumes(pieces);
    for (const int v : lowestVertices({groupOfPiece.begin(), groupOfPiece.end()})) {
        Sweep& sweep = sweeps.emplace_back();
        sweep.vertex = v;
        sweep.group = groupOfVertex(v);
        placeRung(at, sweep);
    }
    joinRungs();
}

/// Of each of these groups; ascending. O(n), where there is one.
std::vector<int> Cutter::State::lowestVertices(std::set<int> groups) const {
    std::vector<int> found;
    for (int v = 0; v < mesh.vertexCount() && !groups.empty(); ++v) {
        if (groups.erase(groupOfVertex(v)) > 0) {
            found.push_back(v);
        }
    }
    return found;
}

void Cutter::State::noteMotion() {
    const std::optional<double> most = std::exchange(moved, std::nullopt);
    if (!tree) {
        return;
    }
    if (most) {
        tree->moved(*most);
    } else {
        tree->movedAnyhow();
    }
}

TriangleFinder& Cutter::State::findTriangles() {
    if (finder != nullptr) {
        return *finder;
    }
    if (!tree) {
        tree.emplace(mesh);
    }
    return *tree;
}

double Cutter::State::margin() const {
    return (kBroadPhaseMargin + cut::largestOffsetScale() * settings.offset) * h;
}

/// After each change of the mesh, before anything is looked up in it. `changed`: each once. Pieces
/// that come off stay in the group until they part.
void Cutter::State::follow(const std::vector<int>& changed, int groupOfNewPieces) {
    if (finder != nullptr || tree) {
        findTriangles().update(changed);
    }
    const std::vector<int> source = pieces.update(mesh, changed).source;
    const std::vector<int> before = std::exchange(groupOfPiece, {});
    for (const int piece : source) {
        groupOfPiece.push_back(piece < 0 ? groupOfNewPieces : before[piece]);
    }
}

int Cutter::State::groupOfVertex(int v) const {
    const int piece = pieces.ofVertex()[v];
    return piece < 0 ? -1 : groupOfPiece[piece];
}

// Pieces that have parted since go on apart, each with its own part of the rung. A piece that has
// gone (debris) takes its sweep along.
void Cutter::State::divideSweeps() {
    const std::vector<int> before =
        std::exchange(groupOfPiece, cut::groupPieces(mesh, pieces, kParted * h, groupOfPiece));
    std::map<int, int> sweepOfGroupBefore;
    std::set<int> parted(groupOfPiece.begin(), groupOfPiece.end());
    for (int i = 0; i < cut::sizeOf(sweeps); ++i) {
        sweepOfGroupBefore[sweeps[i].group] = i;
        sweeps[i].group = groupOfVertex(sweeps[i].vertex);
        parted.erase(sweeps[i].group);
    }
    std::set<int> divided;
    for (const int v : lowestVertices(std::move(parted))) {
        const int parent = sweepOfGroupBefore.at(before[pieces.ofVertex()[v]]);
        Sweep part = sweeps[parent];
        part.vertex = v;
        part.group = groupOfVertex(v);
        sweeps.push_back(std::move(part));
        keepOwnNodes(sweeps[parent].rung, sweeps.back());
        divided.insert(parent);
    }
    for (const int parent : divided) {
        keepOwnNodes(sweeps[parent].rung, sweeps[parent]);
    }
    std::erase_if(sweeps, [](const Sweep& sweep) { return sweep.group < 0; });
}

void Cutter::State::keepOwnNodes(std::vector<RungNode> nodes, Sweep& sweep) {
    std::erase_if(nodes, [&](const RungNode& node) {
        return node.vertex >= 0 && groupOfVertex(node.vertex) != sweep.group;
    });
    setRung(std::move(nodes), sweep);
}

void Cutter::State::joinRungs() {
    rung.clear();
    for (const Sweep& sweep : sweeps) {
        rung.insert(rung.end(), sweep.rung.begin(), sweep.rung.end());
    }
}

CutResult Cutter::State::sweepAll(const Blade& to, double gate) {
    if ((to.b - to.a).norm() <= kStandingStill * h) {
        return outcome(CutOutcome::waiting);
    }
    for (Sweep& sweep : sweeps) {
        cut::followMesh(mesh, sweep.rung);
        sweep.airTies.follow(mesh, sweep.rung);
    }
    divideSweeps();
    CutResult sum;
    for (Sweep& sweep : sweeps) {
        addTo(sum, advance(to, gate, sweep));
    }
    joinRungs();
    if (sum.outcome == CutOutcome::cut) {
        cleanUpBehindFront(sum);
        tieRungs();
    }
    return sum;
}

// The skin beside the air of any rung may have changed.
void Cutter::State::tieRungs() {
    for (Sweep& sweep : sweeps) {
        tie(sweep);
    }
}

void Cutter::State::cleanUpBehindFront(CutResult& result) {
    if (!cleanup) {
        return;
    }
    const std::vector<int> before = changedTriangles(result.delta);
    result.statistics.cleanup = cleanup->behindFront(rung, result.delta);
    followCleanUp(before, result.delta);
    holdLivingVertices();
}

/// The clean-up takes triangles that the step had added out of its delta.
void Cutter::State::followCleanUp(const std::vector<int>& changedBefore, const CutDelta& delta) {
    std::vector<int> changed;
    std::ranges::set_union(changedBefore, changedTriangles(delta), std::back_inserter(changed));
    surface.follow(changed, cleanup->takeRestMotion());
    follow(changed, -1);
}

void Cutter::State::holdLivingVertices() {
    for (Sweep& sweep : sweeps) {
        if (mesh.outgoing(sweep.vertex) < 0) {
            const std::vector<int> living = lowestVertices({sweep.group});
            sweep.vertex = living.empty() ? sweep.vertex : living.front();
        }
    }
}

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

void Cutter::State::tie(Sweep& sweep) {
    sweep.airTies = cut::AirTies(mesh, findTriangles(), isOuter(sweep), h, sweep.rung);
}

std::function<bool(int)> Cutter::State::isOuter(const Sweep& sweep) const {
    return [this, group = sweep.group](int t) {
        const bool ownWall = mesh.kind(t) == SurfaceKind::wall && mesh.wallLabel(t) / 2 == stroke;
        return !ownWall && groupOfVertex(mesh.triangle(t)[0]) == group;
    };
}

CutResult Cutter::State::advance(const Blade& to, double gate, Sweep& sweep) {
    std::vector<RungNode> from = sweep.rung;
    const cut::SweepMotion motion = cut::reparametrize(to, h, from);
    if (motion.advance < std::max(gate, kStandingStill * h)) {
        const bool slides = motion.axial > kAxialSlide * motion.advance && motion.axial > gate;
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
        margin(),
        kBinSize * h,
        [this, group = sweep.group](int t) { return groupOfVertex(mesh.triangle(t)[0]) == group; }};
}

// Nothing is committed until one attempt succeeds.
CutResult Cutter::State::cut(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep) {
    CutResult result = outcome(CutOutcome::refused);
    if (climb(to, from, sweep, result) || resume(to, from, sweep, result)) {
        moveOn(to, result, sweep);
        return result;
    }
    result.statistics.refusedPieces = 1;
    countRefusal(to, sweep);
    return result;
}

// The retry ladder: with older slits along the blade seen open, then with all as they are; a pass
// that once had to do without stays so.
bool Cutter::State::climb(const Blade& to, const std::vector<RungNode>& from, Sweep& sweep,
                          CutResult& result) {
    const cut::BroadPhase candidates = findCandidates(to, sweep, from);
    const auto tryAll = [&](const cut::SlitOpening& opening) {
        std::vector<RungNode> clear = from;
        cut::clearAirEdges(mesh, candidates, opening, to, h, sweep.airTies, clear);
        for (int i = 0; i < cut::attemptCount(); ++i) {
            if (attempt(to, clear, candidates, opening, i, sweep, result)) {
                return true;
            }
        }
        return false;
    };
    if (sweep.opensSlits) {
        const cut::SlitOpening opening(
            mesh, candidates,
            {from, to, h, stroke, sweep.firstVertexOfPass, sweep.onSeams, sweep.sides});
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
    for (const cut::Resumption& way : cut::resumptions(from, to, h)) {
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

bool Cutter::State::attempt(const Blade& to, const std::vector<RungNode>& from,
                            const cut::BroadPhase& candidates, const cut::SlitOpening& opening,
                            int level, Sweep& sweep, CutResult& result) {
    const std::uint64_t retrySeed =
        settings.seed * 7 + static_cast<std::uint64_t>(mesh.triangleSlots());
    Bounds bodyBox = findTriangles().bounds();
    bodyBox.widen(kBroadPhaseMargin * h);  // predicates may see vertices that far outside
    const cut::StepInput in{mesh,
                            candidates,
                            pieces.ofVertex(),
                            surface,
                            opening,
                            from,
                            to,
                            h,
                            settings.offset,
                            settings.seed,
                            stroke,
                            sweep.pass,
                            sweep.firstVertexOfPass,
                            cut::attemptAt(level, settings.tolerance, retrySeed),
                            bodyBox};
    const int tries = result.statistics.tries + 1;
    const std::string reason = result.reason;
    result.statistics.tries = tries;
    try {
        const cut::PlannedStep step = cut::planStep(in);
        requireVolume(step.plan);
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
        cleanup.emplace(mesh, h);
    }
    cut::CommitResult committed = cut::commit(mesh, step.plan, h, stroke);
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

void Cutter::State::cleanUpAtEnd(CutResult& result) {
    if (!cleanup) {
        return;
    }
    const std::vector<int> changedBefore = changedTriangles(result.delta);
    const CleanupStatistics before = result.statistics.cleanup;
    CleanupStatistics& sum = result.statistics.cleanup = cleanup->atEnd(result.delta);
    if (settings.wallCoarsening > 1) {
        cleanup->coarsen(settings.wallCoarsening, result.delta);
    }
    followCleanUp(changedBefore, result.delta);
    sum.collapses += before.collapses;
    sum.flips += before.flips;
    sum.slides += before.slides;
    cleanup.reset();
}

void Cutter::State::removeDebris(CutResult& result) {
    const std::vector<int> debris =
        cut::findDebris(mesh, pieces, firstTriangle, settings.debrisVolume * restVolume);
    if (debris.empty()) {
        return;
    }
    for (const int piece : debris) {
        ++result.statistics.debris.pieces;
        result.statistics.debris.volume += pieces.pieces()[piece].restVolume;
    }
    const std::vector<int> removed =
        cut::removePieces(mesh, pieces, debris, firstTriangle, result.delta);
    surface.follow(removed, 0);
    follow(removed, -1);
}

Cutter::Cutter(SurfaceMesh& mesh, const CutSettings& settings)
    : state_(std::make_unique<State>(State{mesh, settings})) {
    state_->h = settings.wallEdgeLength > 0 ? settings.wallEdgeLength : defaultWallEdge(mesh);
    state_->stroke = strokesSoFar(mesh);
    state_->pass = kPassesPerStroke * state_->stroke;
}

Cutter::~Cutter() = default;
Cutter::Cutter(Cutter&&) noexcept = default;
Cutter::Cutter(const Cutter& other) : state_(std::make_unique<State>(*other.state_)) {}
Cutter& Cutter::operator=(Cutter&&) noexcept = default;

void Cutter::begin(const Blade& blade) {
    state_->noteMotion();
    state_->start(blade);
}

CutResult Cutter::advance(const Blade& blade) {
    assert(state_->inStroke);
    state_->blade = blade;
    state_->noteMotion();
    return state_->sweepAll(blade, state_->settings.gate * state_->h);
}

CutResult Cutter::finish() {
    State& state = *state_;
    assert(state.inStroke);
    state.noteMotion();
    CutResult result = state.sweepAll(state.blade, state.leastFlush());
    state.inStroke = false;
    state.sweeps.clear();
    state.rung.clear();
    if (result.outcome != CutOutcome::cut) {
        result.delta.firstNewVertex = state.mesh.vertexCount();
    }
    state.cleanUpAtEnd(result);
    state.removeDebris(result);
    return result;
}

void Cutter::useFinder(TriangleFinder* finder) {
    state_->finder = finder;
    state_->tree.reset();
}

void Cutter::boundMotion(double distance) {
    state_->moved = state_->moved.value_or(0) + distance;
}

void Cutter::setWallCoarsening(double factor) {
    state_->settings.wallCoarsening = factor;
}

void Cutter::setDebrisVolume(double share) {
    state_->settings.debrisVolume = share;
}

bool Cutter::inStroke() const {
    return state_->inStroke;
}
OrientedBox Cutter::reach(std::span<const Blade> path, double time) const {
    std::vector<Vec3> points;
    const SurfaceMesh& mesh = state_->mesh;
    for (const Sweep& sweep : state_->sweeps) {
        std::vector<RungNode> rung = sweep.rung;
        cut::followMesh(mesh, rung);
        sweep.airTies.follow(mesh, rung);
        for (const RungNode& node : rung) {
            const bool moves = node.vertex >= 0;
            points.push_back(moves ? Vec3(node.position + time * mesh.velocity(node.vertex))
                                   : node.position);
        }
    }
    for (const Blade& blade : path) {
        points.insert(points.end(), {blade.a, blade.b});
    }
    OrientedBox box = orientedBoxAlong(cut::sweepAxes(path.back(), points), points);
    box.widen(kRoomForReach * state_->margin());
    return box;
}

std::vector<int> Cutter::followedVertices() const {
    std::vector<int> vertices;
    for (const Sweep& sweep : state_->sweeps) {
        sweep.airTies.addVertices(vertices);
        for (const RungNode& node : sweep.rung) {
            if (node.vertex >= 0) {
                vertices.push_back(node.vertex);
            }
        }
    }
    state_->surface.addVertices(vertices);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

const cut::StrokeSurface& Cutter::strokeSurface() const {
    return state_->surface;
}
const std::vector<RungNode>& Cutter::rung() const {
    return state_->rung;
}

}  // namespace kerf
