#include "sim/run/start/prepared_body.h"

#include <cassert>

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/mesh/invariants.h"

namespace kerf {

namespace {

std::vector<int> firstVertices(std::span<const PlacedModel> models) {
    return mapped(models, &PlacedModel::firstVertex);
}

}  // namespace

double sizeOfModels(std::span<const Vec3> restPositions, std::span<const PlacedModel> models) {
    double size = 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
        const std::size_t first = models[m].firstVertex;
        const std::size_t end =
            m + 1 < models.size() ? models[m + 1].firstVertex : restPositions.size();
        size = std::max(size, boxOf(restPositions.subspan(first, end - first)).diagonal());
    }
    return size;
}

int UncutBody::modelOf(int vertex) const {
    const auto after = std::ranges::upper_bound(models, vertex, {}, &PlacedModel::firstVertex);
    return static_cast<int>(after - models.begin()) - 1;
}

double UncutBody::sizeOfModels() const {
    return kerf::sizeOfModels(mesh.restPositions(), models);
}

std::shared_ptr<const UncutBody> makeUncutBody(SurfaceMesh atRest, std::vector<PlacedModel> models,
                                               const StageListener& enter) {
    const auto begin = [&](const char* stage) {
        if (enter) {
            enter(stage);
        }
    };
    auto running = std::make_shared<SurfaceMesh>(std::move(atRest));
    begin("Building the constraints");
    BodyUpdater body(*running, firstVertices(models));
    begin("Preparing the blade");
    Cutter cutter(*running, CutSettings{});
    cutter.prepare();
    const bool closed = checkClosedManifold(*running).empty();
    return std::make_shared<const UncutBody>(UncutBody{
        *running, running, std::move(body), std::move(cutter), closed, std::move(models)});
}

/// From the placements that the body has, so that it does not matter which ones were tried between.
SurfaceMesh placedMesh(const UncutBody& uncut, std::span<const PlacedModel> models) {
    SurfaceMesh placed = uncut.mesh;
    for (std::size_t m = 0; m < models.size(); ++m) {
        const Placement& before = uncut.models[m].placement;
        const PlacementMap from(before);
        const PlacementMap to(models[m].placement);
        const int end = m + 1 < models.size() ? models[m + 1].firstVertex : placed.vertexCount();
        for (int v = models[m].firstVertex; v < end && models[m].placement != before; ++v) {
            const Vec3 at = to.toScene(from.toModel(uncut.mesh.restPosition(v)));
            placed.setPosition(v, at);
            placed.setRestPosition(v, at);
        }
    }
    return placed;
}

PreparedBody::PreparedBody(SurfaceMesh atRest, const StageListener& enter,
                           std::vector<PlacedModel> models)
    : uncut(makeUncutBody(std::move(atRest), std::move(models), enter)),
      body(std::make_unique<BodyUpdater>(uncut->body)),
      cutter(std::make_unique<Cutter>(uncut->cutter)) {
    pages.assign(body->model().pieceOfVertex, body->model().pieces.size());
}

BodyUpload::BodyUpload(PreparedBody prepared)
    : prepared_(std::move(prepared)),
      state_(stateOf(prepared_.uncut->mesh)),
      solver_(std::make_unique<GpuSolver>()) {}

void BodyUpload::advance() {
    assert(!done());
    solver_->setModelPortion(next_, prepared_.body->model(), state_, prepared_.pages);
    ++next_;
}

void BodyUpload::finish() {
    while (!done()) {
        advance();
    }
}

}  // namespace kerf
