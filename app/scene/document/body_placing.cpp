#include "app/scene/document/body_placing.h"

namespace kerf::app {
namespace {

PlacedBody placedBody(const UncutBody& first, std::vector<PlacedModel> models,
                      WorkProgress& progress) {
    progress.enter("Moving the model");
    SurfaceMesh mesh = placedMesh(first, models);
    PlacedBody placed;
    placed.body = makeUncutBody(std::move(mesh), std::move(models),
                                [&](const char* stage) { progress.enter(stage); });
    progress.enter("Computing depth below the skin");
    placed.depth = render::measureSkinDepth(placed.body->mesh);
    progress.enter("Uploading to GPU");
    return placed;
}

std::vector<PlacedModel> modelsAfter(const UncutBody& now, const Place& place) {
    std::vector<PlacedModel> models = now.models;
    models.at(place.model).placement = place.placement;
    return models;
}

}  // namespace

BodyPlacing::BodyPlacing(const Simulation& simulation, const Place& place)
    : place_(place),
      job_([first = simulation.firstUncut(), models = modelsAfter(*simulation.uncut(), place)](
               WorkProgress& progress) { return placedBody(*first, models, progress); }) {}

}  // namespace kerf::app
