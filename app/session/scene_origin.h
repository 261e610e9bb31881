#pragma once

#include "app/session/session.h"

namespace kerf::app {

// A session file speaks of places in the scene as they are; a simulation far from the origin counts
// them from a point beside its models (see originOf()), so that floats hold them. Both ways are
// exact for what lies no farther from the models than these from the origin.

/// Moves the origin of all positions by `by` [m], of heights of the floor too.
SessionAction countedFrom(SessionAction action, const Vec3& by);
Command countedFrom(Command command, const Vec3& by);
render::Camera countedFrom(render::Camera camera, const Vec3& by);
Params countedFrom(Params params, const Vec3& by);
std::vector<StaticBox> countedFrom(std::vector<StaticBox> boxes, const Vec3& by);
/// A session with positions relative to `origin`, which becomes its Session::origin.
Session withOrigin(Session session, const Vec3& origin);

/// A command as a replay of its saved session reads it: positions near the origin of the scene are
/// rounded as in the file.
Command asReplayed(const Command& command, const Vec3& origin);

}  // namespace kerf::app
