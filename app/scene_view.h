#pragma once

#include <string>
#include <vector>

#include "render/renderer.h"
#include "sim/simulation.h"

namespace kerf::app {

/// What a picture shows of a simulation as it stands, in the window as in a replay. `modelName`:
/// see ModelReference::name(); `restBounds`: of the uncut rest shape; `sweep`: poses of the running
/// stroke.
render::SceneView sceneOf(const Simulation& simulation, const std::string& modelName,
                          const Bounds& restBounds, const std::vector<Blade>& sweep);

}  // namespace kerf::app
