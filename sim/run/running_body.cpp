#include "sim/run/running_body.h"

#include <algorithm>
#include <utility>

#include "sim/base/boxes.h"
#include "sim/base/pausing.h"
#include "sim/base/sort_unique.h"
#include "sim/body/solver_uniforms.h"
#include "sim/mesh/oriented_box.h"

namespace kerf {

namespace {

OrientedBox oriented(const Bounds& box) {
    return {box.center(), Eigen::Matrix3d::Identity(), 0.5 * (box.high - box.low)};
}

}  // namespace

RunningBody::RunningBody(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver)
    : first(std::move(prepared.uncut)),
      meshOwner(std::move(prepared.mesh)),
      updater(std::move(prepared.body)),
      solverOwner(std::move(loadedSolver)),
      cutter(std::move(*prepared.cutter)) {
    take(first);
    lookUpTriangles();
    beginAtRest();
}

void RunningBody::take(std::shared_ptr<const UncutBody> body) {
    uncut = std::move(body);
    diagonal = boxOf(uncut->mesh.restPositions()).diagonal();
    wallEdge = contactEdgeLength(uncut->body.model());
}

void RunningBody::startAsAtFirst() {
    take(first);
    startAnew();
}

/// From the placement at first, so that it does not matter which ones were tried in between.
SurfaceMesh RunningBody::placedMesh(const Placement& placement) const {
    SurfaceMesh placed = first->mesh;
    const PlacementMap from(first->placement);
    const PlacementMap to(placement);
    for (int v = 0; v < placed.vertexCount() && placement != first->placement; ++v) {
        const Vec3 at = to.toScene(from.toModel(first->mesh.restPosition(v)));
        placed.setPosition(v, at);
        placed.setRestPosition(v, at);
    }
    return placed;
}

void RunningBody::startAnew(SurfaceMesh placed, const Placement& placement) {
    if (placement == first->placement) {
        startAsAtFirst();
        return;
    }
    mesh = std::move(placed);
    take(std::make_shared<const UncutBody>(makeUncutBody(mesh, placement)));
    startAnew();
}

void RunningBody::startAnew() {
    whole = false;
    mesh = uncut->mesh;
    pausePoint();
    updater = std::make_unique<BodyUpdater>(uncut->body);
    solver.setModel(model(), stateOf(mesh));
    pausePoint();
    cutter.emplace(uncut->cutter);
    lookUpTriangles();
    beginAtRest();
    becomeWhole();
}

/// As another one than before.
void RunningBody::becomeWhole() {
    ++modelRevision;
    whole = true;
}

/// With updater, solver and cutter as new.
void RunningBody::beginAtRest() {
    memory = {};
    memory.volumeTargets.reset(model());
    memory.closed = uncut->closed;
    sync.invalidate();  // by the rounding to float
    forgetPieces();
}

void RunningBody::measureAtRest() {
    memory.measure = solver.measure();
    sync.setBounds(memory.measure.bounds);
    solver.savedPieces().save();
}

void RunningBody::apply(const Params& params) {
    solver.setUniforms(solverUniforms(params));
    volumesHeld = holdsVolume(params);
    solver.setVolumeTargets(memory.volumeTargets.targets());
    CutSettings& settings = cutter->settings();
    settings.wallCoarsening = params.wallCoarsening;
    settings.debrisVolume = params.debrisVolume;
    settings.openCut = params.openCut != 0;
    settings.search = params.cutSearch;
    solver.collisions().setSettings(contactSettings(params));
}

SnapshotPointer RunningBody::capture() {
    mesh.bringAll();
    const auto rested = [](const auto& part) {
        pausePoint();
        return part;
    };
    return std::make_shared<const Snapshot>(Snapshot{rested(mesh), rested(*updater),
                                                     rested(*cutter), solver.pages(), memory,
                                                     solver.collisions().memory(), uncut});
}

void RunningBody::restore(const Snapshot& snapshot) {
    whole = false;
    take(snapshot.uncut);
    mesh = snapshot.mesh;
    sync.forget();
    pausePoint();
    updater = std::make_unique<BodyUpdater>(snapshot.body);
    pausePoint();
    cutter.emplace(snapshot.cutter);
    lookUpTriangles();
    memory = snapshot.memory;
    sync.setBounds(memory.measure.bounds);
    solver.restoreModel(model(), stateOf(mesh), snapshot.pages);
    solver.collisions().remember(snapshot.contact);
    solver.setVolumeTargets(memory.volumeTargets.targets());
    solver.masses().setPinned(memory.pins.vertices());
    solver.savedPieces().save();
    forgetPieces();
    becomeWhole();
}

void RunningBody::prepareStep(const Params& params) {
    if (volumesHeld && memory.volumeTargets.fade(params.timeStep)) {
        solver.setVolumeTargets(memory.volumeTargets.targets());
    }
    std::vector<shared::PullRecord> pulls = memory.hands.advance(params.timeStep);
    if (memory.recovery.draws()) {
        const std::vector<shared::PullRecord> leads = leadsBack(params);
        pulls.insert(pulls.end(), leads.begin(), leads.end());
    }
    solver.setPulls(pulls);
}

std::vector<shared::PullRecord> RunningBody::leadsBack(const Params& params) {
    std::vector<std::uint32_t> held = memory.hands.heldVertices();
    const std::vector<std::uint32_t>& pinned = memory.pins.vertices();
    held.insert(held.end(), pinned.begin(), pinned.end());
    sortUnique(held);
    return memory.recovery.advance({model(), mesh, params, std::move(held)});
}

/// What needs no result is done while the GPU measures.
void RunningBody::measureStep() {
    solver.measurer().start();
    sync.invalidate();
    forgetPieces();
    memory.measure = solver.measurer().take();
}

void RunningBody::bringLostPiecesBack() {
    solver.savedPieces().restoreAtRest(memory.measure.lostPieces);
    memory.measure = solver.measure();
}

double RunningBody::endStep() {
    if (!volumesHeld) {
        memory.volumeTargets.startAt(memory.measure.pieceVolumes);
    }
    solver.savedPieces().save();
    const double prefetchMs = sync.takePrefetched();
    sync.setBounds(memory.measure.bounds);
    if (readsAllBack) {
        mesh.bringAll();
    }
    return prefetchMs;
}

/// By the box of the body, which is at hand, and that of the strip, then by what lies in the
/// latter.
bool RunningBody::isNear(std::span<const Vec3> strip) {
    Bounds swept = boxOf(strip);
    swept.widen(model().edgeLength);
    if (!swept.overlaps(memory.measure.bounds)) {
        return false;
    }
    OrientedBox sweptBox = orientedBoxOf(strip);
    sweptBox.widen(model().edgeLength);
    if (!overlap(sweptBox, oriented(memory.measure.bounds))) {
        return false;
    }
    if (readsAllBack) {
        sync.forget();  // the cutter does not tell it of changes then
    }
    return !sync.near(sweptBox).empty();
}

std::vector<RungNode> RunningBody::front() const {
    std::vector<RungNode> nodes = cutter->rung();
    for (RungNode& node : nodes) {
        if (node.vertex >= 0) {
            node.position = mesh.position(node.vertex);
        }
    }
    return nodes;
}

void RunningBody::readAllBack(bool all) {
    readsAllBack = all;
    lookUpTriangles();
}

void RunningBody::lookUpTriangles() {
    cutter->useFinder(readsAllBack ? nullptr : &sync);
}

bool RunningBody::looksCollapsed() const {
    constexpr double kLittle = 0.5;
    const std::vector<PieceModel>& pieces = model().pieces;
    bool little = false;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        little = little || (pieces[p].holdsVolume &&
                            memory.measure.pieceVolumes[p] < kLittle * pieces[p].restVolume);
    }
    return little || solver.collisions().expectsFolds();
}

bool RunningBody::isOpen() const {
    return std::ranges::any_of(model().pieces, &PieceModel::open);
}

const PieceMap& RunningBody::pieces() {
    if (!pieces_) {
        pieces_ = findPieces(mesh);
    }
    return *pieces_;
}

}  // namespace kerf
