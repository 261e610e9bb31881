#pragma once

#include <array>
#include <vector>

#include "sim/base/math.h"

namespace kerf {

class SurfaceMesh;

/// Where the three corners of a triangle lie on a texture; v runs upwards.
using CornerUvs = std::array<Eigen::Vector2f, 3>;

/// The texture coordinates of a body that was cut, by slot of `cut`, from those of the uncut mesh,
/// by slot of `uncut`. A triangle that a cut made out of the skin gets what its corners have at
/// their places in the uncut rest shape, on the side of a seam where its middle lies. Walls and
/// dead slots get zeros. An empty list stays empty.
std::vector<CornerUvs> carryUvs(const SurfaceMesh& uncut, const std::vector<CornerUvs>& uvs,
                                const SurfaceMesh& cut);

}  // namespace kerf
