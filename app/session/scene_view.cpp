#include "app/session/scene_view.h"

namespace kerf::app {

render::BodyLook lookOf(const Session& session) {
    return render::colored(render::lookFor(session.model.name()), session.colors);
}

namespace {

// Of the body's diagonal: no arrow is longer.
constexpr double kLongestArrow = 0.5;

/// Half as long as it can be where a cut as wide as the body takes that force.
std::optional<Vec3> arrowOf(const Simulation& simulation) {
    const std::optional<BladeLoad>& load = simulation.report().bladeLoad;
    const Params& params = simulation.params();
    if (!simulation.blade() || !load || params.bladeFeels == 0 || load->force.isZero(0)) {
        return std::nullopt;
    }
    const double size = simulation.bounds().diagonal();
    return kLongestArrow * size / (load->force.norm() + params.toughness * size) * load->force;
}

}  // namespace

render::SceneView sceneOf(const Simulation& simulation, const render::BodyLook& look,
                          const Bounds& restBounds, const std::vector<Blade>& strokePoses) {
    render::SceneView scene;
    scene.body = simulation.bodyView();
    scene.bodyRevision = simulation.bodyRevision();
    scene.hasWalls = std::ranges::any_of(simulation.subdivisions(), [](auto n) { return n > 0; });
    scene.look = look;
    scene.restBounds = restBounds;
    scene.boxes = simulation.boxes();
    scene.floor = simulation.params().floor;
    scene.blade = simulation.bladeEdge();
    scene.bladeForce = arrowOf(simulation);
    scene.bladeBody = simulation.bladeBody();
    scene.strokePoses = strokePoses;
    scene.focus = simulation.bounds();
    return scene;
}

}  // namespace kerf::app
