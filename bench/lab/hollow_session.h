#pragma once

#include <optional>

#include "app/session/session.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The picture with which hollowSession() ends.
inline constexpr const char* kHollowFile = "hollow.png";

/// A session that shows what its cut leaves open: the course of `session` up to the first picture
/// that it takes while its blade cuts, with two hands that draw the lips apart meanwhile and one
/// picture at the end, from nearer and along the blade. In `session` itself the lips lie together,
/// so nothing can be seen of the hollow. `mesh` is that of its model. Nothing where the session
/// takes no picture during its first stroke, or the body has no skin on either side of it.
std::optional<Session> hollowSession(const Session& session, const SurfaceMesh& mesh);

}  // namespace kerf::app
