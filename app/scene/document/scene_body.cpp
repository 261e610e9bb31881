#include "app/scene/document/scene_body.h"

namespace kerf::app {
namespace {

/// That of a model's file, in the scene [m].
double unitOf(const Placement& placement) {
    return placement.metresPerUnit() * placement.scale;
}

}  // namespace

SceneBody::SceneBody(Document opened, BodyUpload upload)
    : document(std::move(opened)),
      simulation(std::move(upload), document.session.params, document.session.boxes),
      rest(simulation, document) {}

Place SceneBody::placeCommand(const Placement& wanted, bool continues, int model) const {
    const PlacementMap map(simulation.placement(model));
    const UncutBody& uncut = rest.uncut();
    const std::vector<PlacedModel>& models = uncut.models;
    const int last = model + 1;
    const int end =
        last < simulation.modelCount() ? models[last].firstVertex : uncut.mesh.vertexCount();
    std::vector<Vec3> own;
    own.reserve(end - models[model].firstVertex);
    for (int v = models[model].firstVertex; v < end; ++v) {
        own.push_back(map.toModel(uncut.mesh.restPosition(v)));
    }
    const Bounds& bounds = rest.models()[model].bounds;
    Vec3 ground = bounds.center();
    ground.y() = simulation.params().floor.value_or(bounds.low.y());
    return {standing(wanted, own, ground), continues, model};
}

Session SceneBody::start() const {
    Session start;
    start.origin = document.session.origin;
    start.model = document.session.model;
    start.placement = simulation.placement();
    start.moreModels = document.session.moreModels;
    for (std::size_t m = 0; m < start.moreModels.size(); ++m) {
        start.moreModels[m].placement = simulation.placement(static_cast<int>(m) + 1);
    }
    start.params = simulation.params();
    start.boxes = simulation.boxes();
    start.colors = document.session.colors;
    return start;
}

double SceneBody::proposedEdge(int model) const {
    const auto& [bounds, volume, triangles] = rest.models()[model];
    return kerf::proposedEdge(triangles, bounds.diagonal()) / unitOf(simulation.placement(model));
}

ui::Remesh SceneBody::coarser(int triangles) const {
    const auto size = [](const ModelFigures& model) { return model.triangles.triangles; };
    const auto largest = std::ranges::max_element(rest.models(), {}, size);
    const auto model = static_cast<int>(largest - rest.models().begin());
    return {model, edgeOf(largest->triangles, triangles) / unitOf(simulation.placement(model))};
}

}  // namespace kerf::app
