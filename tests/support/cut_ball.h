#pragma once

#include "sim/body/body_model.h"

namespace kerf::test {

/// A ball of 0.2 m with 12 n^2 triangles, cut from above at z = 0.003 m down to a height [m]; whole
/// for a height above it.
SurfaceMesh cutBall(double height, int n = 8);
/// Its model, with turned ISPCs.
BodyModel cutBallModel(double height);

/// The vertices that lie below a height at rest [m].
std::vector<std::uint32_t> verticesBelow(const BodyModel& model, double height);

}  // namespace kerf::test
