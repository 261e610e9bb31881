#include "sim/run/prepared_body.h"

#include <algorithm>
#include <utility>

#include "sim/base/boxes.h"
#include "sim/mesh/invariants.h"

namespace kerf {

namespace {

std::vector<int> firstVertices(std::span<const PlacedModel> models) {
    std::vector<int> first;
    first.reserve(models.size());
    for (const PlacedModel& model : models) {
        first.push_back(model.firstVertex);
    }
    return first;
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

UncutBody makeUncutBody(SurfaceMesh& atRest, std::vector<PlacedModel> models,
                        const StageListener& enter) {
    const auto begin = [&](const char* stage) {
        if (enter) {
            enter(stage);
        }
    };
    begin("Building the constraints");
    BodyUpdater body(atRest, firstVertices(models));
    begin("Preparing the blade");
    Cutter cutter(atRest, CutSettings{});
    cutter.prepare();
    return {atRest, std::move(body), std::move(cutter), checkClosedManifold(atRest).empty(),
            std::move(models)};
}

PreparedBody::PreparedBody(SurfaceMesh atRest, const StageListener& enter,
                           std::vector<PlacedModel> models)
    : mesh(std::make_unique<SurfaceMesh>(std::move(atRest))),
      uncut(std::make_shared<const UncutBody>(makeUncutBody(*mesh, std::move(models), enter))) {
    body = std::make_unique<BodyUpdater>(uncut->body);
    cutter = std::make_unique<Cutter>(uncut->cutter);
    pages.assign(body->model().pieceOfVertex, body->model().pieces.size());
}

}  // namespace kerf
