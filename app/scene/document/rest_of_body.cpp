#include "app/scene/document/rest_of_body.h"

#include "app/practice/score.h"
#include "sim/mesh/piece_figures.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {
namespace {

std::vector<ModelFigures> figuresOf(const UncutBody& uncut) {
    const SurfaceMesh& mesh = uncut.mesh;
    std::vector<ModelFigures> figures(uncut.models.size());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        figures[uncut.modelOf(v)].bounds.add(mesh.restPosition(v));
    }
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const auto& [a, b, c] = mesh.triangle(t);
        ModelFigures& model = figures[uncut.modelOf(a)];
        const Vec3& origin = model.bounds.low;
        const Vec3 normal = (mesh.restPosition(b) - origin).cross(mesh.restPosition(c) - origin);
        model.volume += (mesh.restPosition(a) - origin).dot(normal) / 6;
        model.triangles.add(restCornersOf(mesh, t));
    }
    return figures;
}

std::optional<Bounds> boundsOfLines(const std::optional<Task>& task) {
    const Bounds bounds = task ? boxOfLines(*task) : Bounds{};
    return bounds.empty() ? std::nullopt : std::optional(bounds);
}

}  // namespace

RestOfBody::RestOfBody(const Simulation& simulation, const Document& document)
    : uncut_(simulation.uncut()),
      bounds_(meshBounds(uncut_->mesh)),
      models_(figuresOf(*uncut_)),
      homeView_(document.camera),
      lines_(boundsOfLines(document.session.task)) {}

void RestOfBody::follow(const Simulation& simulation, const Document& document) {
    if (uncut_ == simulation.uncut()) {
        return;
    }
    uncut_ = simulation.uncut();
    bounds_ = meshBounds(uncut_->mesh);
    models_ = figuresOf(*uncut_);
    const bool asOpened = uncut_->models == document.placed;
    homeView_ = asOpened ? document.camera : sessionCamera(Session{}, bounds_);
    lines_ = asOpened ? boundsOfLines(document.session.task) : std::nullopt;
    ++revision_;
}

}  // namespace kerf::app
