#include "app/scene_view.h"

namespace kerf::app {

render::SceneView sceneOf(const Simulation& simulation, const std::string& modelName,
                          const Bounds& restBounds, const std::vector<Blade>& sweep) {
    render::SceneView scene;
    scene.body = simulation.bodyView();
    scene.material = render::materialFor(modelName);
    scene.restBounds = restBounds;
    scene.floor = simulation.params().floor;
    scene.blade = simulation.blade();
    scene.sweep = sweep;
    scene.focus = simulation.bounds();
    return scene;
}

}  // namespace kerf::app
