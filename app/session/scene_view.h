#pragma once

#include <vector>

#include "app/session/session.h"
#include "render/scene/scene.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// The look of a session's model, in the session's colours.
render::BodyLook lookOf(const Session& session);

/// What a picture shows of a simulation as it stands, in the window as in a replay.
/// `restBounds`: of the uncut rest shape; `sweep`: poses of the running stroke.
render::SceneView sceneOf(const Simulation& simulation, const render::BodyLook& look,
                          const Bounds& restBounds, const std::vector<Blade>& sweep);

}  // namespace kerf::app
