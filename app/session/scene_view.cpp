#include "app/session/scene_view.h"

namespace kerf::app {

render::Material materialOf(const Session& session) {
    return render::colored(render::materialFor(session.model.name()), session.colors);
}

render::SceneView sceneOf(const Simulation& simulation, const render::Material& material,
                          const Bounds& restBounds, const std::vector<Blade>& strokePoses) {
    render::SceneView scene;
    scene.body = simulation.bodyView();
    scene.material = material;
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
