#pragma once

#include "app/session/session.h"
#include "render/scene/scene.h"
#include "sim/run/simulation.h"

namespace kerf::app {

/// The look of a session's model, in the session's colours.
render::BodyLook lookOf(const Session& session);

/// All that a picture shows of the present simulation, in the window and in a replay. `restBounds`
/// are those of the uncut rest shape, `strokePoses` the poses of the running stroke.
render::SceneView sceneOf(const Simulation& simulation, const render::BodyLook& look,
                          const Bounds& restBounds, const std::vector<Blade>& strokePoses);

}  // namespace kerf::app
