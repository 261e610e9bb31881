#include "app/session/scene_view.h"

#include <algorithm>

namespace kerf::app {

render::BodyLook lookOf(const Session& session) {
    return render::colored(render::lookFor(session.model.name()), session.colors);
}

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
    scene.blade = simulation.blade();
    scene.bladeBody = simulation.bladeBody();
    scene.strokePoses = strokePoses;
    scene.focus = simulation.bounds();
    return scene;
}

}  // namespace kerf::app
