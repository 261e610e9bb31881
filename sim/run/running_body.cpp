#include "sim/run/running_body.h"

#include <algorithm>
#include <utility>

#include "sim/base/boxes.h"
#include "sim/base/float_rounding.h"
#include "sim/body/solver_uniforms.h"
#include "sim/cut/cut_change.h"
#include "sim/mesh/oriented_box.h"

namespace kerf {

namespace {

/// Vertices become what the GPU will hold, so that both sides go on from the same numbers.
void roundVertices(SurfaceMesh& mesh, const std::vector<std::uint32_t>& vertices) {
    for (const std::uint32_t vertex : vertices) {
        const int v = static_cast<int>(vertex);
        mesh.setPosition(v, nearestFloats(mesh.position(v)));
        mesh.setVelocity(v, nearestFloats(mesh.velocity(v)));
    }
}

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
      cutter(std::move(*prepared.cutter)),
      closed(uncut->closed) {
    lookUpTriangles();
    beginAtRest();
}

void RunningBody::startAnew() {
    mesh = uncut->mesh;
    updater = std::make_unique<BodyUpdater>(uncut->body);
    solver.setModel(model(), stateOf(mesh));
    closed = uncut->closed;
    cutter.emplace(uncut->cutter);
    lookUpTriangles();
    beginAtRest();
}

/// With updater, solver and cutter as new.
void RunningBody::beginAtRest() {
    volumeTargets.reset(model());
    sync.invalidate();  // by the rounding to float
    hands = {};
    pins = {};
    subdivisions = {};
    foldedSteps = 0;
    pieces_.reset();
}

void RunningBody::measureAtRest() {
    measure = solver.measure();
    sync.setBounds(measure.bounds);
    solver.savedPieces().save();
}

void RunningBody::apply(const Params& params) {
    solver.setUniforms(solverUniforms(params));
    volumesHeld = holdsVolume(params);
    solver.setVolumeTargets(volumeTargets.targets());
    cutter->setWallCoarsening(params.wallCoarsening);
    cutter->setDebrisVolume(params.debrisVolume);
    cutter->setOpenCut(params.openCut != 0);
    cutter->setSearch(params.cutSearch);
    solver.collisions().setSettings(contactSettings(params));
}

SnapshotPointer RunningBody::capture() {
    mesh.bringAll();
    return std::make_shared<const Snapshot>(
        Snapshot{mesh, *updater, *cutter, solver.pages(), volumeTargets, hands, pins, measure,
                 solver.collisions().memory(), closed, subdivisions, foldedSteps});
}

void RunningBody::restore(const Snapshot& snapshot) {
    mesh = snapshot.mesh;
    sync.forget();
    updater = std::make_unique<BodyUpdater>(snapshot.body);
    cutter.emplace(snapshot.cutter);
    lookUpTriangles();
    volumeTargets = snapshot.volumeTargets;
    hands = snapshot.hands;
    pins = snapshot.pins;
    measure = snapshot.measure;
    sync.setBounds(measure.bounds);
    closed = snapshot.closed;
    subdivisions = snapshot.subdivisions;
    foldedSteps = snapshot.foldedSteps;
    solver.restoreModel(model(), stateOf(mesh), snapshot.pages);
    solver.collisions().remember(snapshot.contact);
    solver.setVolumeTargets(volumeTargets.targets());
    solver.masses().setPinned(pins.vertices());
    solver.savedPieces().save();
    pieces_.reset();
}

void RunningBody::prepareStep(double timeStep) {
    if (volumesHeld && volumeTargets.fade(timeStep)) {
        solver.setVolumeTargets(volumeTargets.targets());
    }
    solver.setPulls(hands.advance(timeStep));
}

/// What needs no result is done while the GPU measures.
void RunningBody::measureStep() {
    solver.measurer().start();
    sync.invalidate();
    pieces_.reset();
    measure = solver.measurer().take();
}

void RunningBody::bringLostPiecesBack() {
    solver.savedPieces().restoreAtRest(measure.lostPieces);
    measure = solver.measure();
}

double RunningBody::endStep() {
    if (!volumesHeld) {
        volumeTargets.startAt(measure.pieceVolumes);
    }
    solver.savedPieces().save();
    const double prefetchMs = sync.takePrefetched();
    sync.setBounds(measure.bounds);
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
    if (!swept.overlaps(measure.bounds)) {
        return false;
    }
    OrientedBox sweptBox = orientedBoxOf(strip);
    sweptBox.widen(model().edgeLength);
    if (!overlap(sweptBox, oriented(measure.bounds))) {
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

std::string RunningBody::adopt(const CutDelta& delta) {
    const bool wasOpen = isOpen();
    const std::vector<std::uint32_t> written = rewrittenVertices(mesh, delta);
    roundVertices(mesh, written);
    const BodyChange change = updater->update(delta);
    solver.update(model(), change, written, stateOf(mesh, written));
    if (change.pieces.piecesChanged || isOpen() != wasOpen) {
        measure = solver.measure();
    }
    volumeTargets.follow(change.pieces.source, model(), measure.pieceVolumes);
    solver.setVolumeTargets(volumeTargets.targets());
    if (pins.follow(mesh, delta)) {
        solver.masses().setPinned(pins.vertices());
    }
    pieces_.reset();
    std::string defect = checkClosedManifoldAround(mesh, changedTriangles(delta));
    closed = closed && defect.empty();
    return defect;
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
