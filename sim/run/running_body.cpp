#include "sim/run/running_body.h"

#include <algorithm>
#include <utility>

#include "sim/base/boxes.h"
#include "sim/base/pausing.h"
#include "sim/body/solver_uniforms.h"
#include "sim/mesh/oriented_box.h"

namespace kerf {

namespace {

OrientedBox oriented(const Bounds& box) {
    return {box.center(), Eigen::Matrix3d::Identity(), 0.5 * (box.high - box.low)};
}

}  // namespace

RunningBody::RunningBody(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver)
    : uncut(std::move(prepared.uncut)),
      diagonal(boxOf(uncut->mesh.restPositions()).diagonal()),
      wallEdge(contactEdgeLength(uncut->body.model())),
      meshOwner(std::move(prepared.mesh)),
      updater(std::move(prepared.body)),
      solverOwner(std::move(loadedSolver)),
      cutter(std::move(*prepared.cutter)) {
    lookUpTriangles();
    beginAtRest();
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
                                                     solver.collisions().memory()});
}

void RunningBody::restore(const Snapshot& snapshot) {
    whole = false;
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
    whole = true;
}

void RunningBody::prepareStep(double timeStep) {
    if (volumesHeld && memory.volumeTargets.fade(timeStep)) {
        solver.setVolumeTargets(memory.volumeTargets.targets());
    }
    solver.setPulls(memory.hands.advance(timeStep));
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
