#pragma once

#include <functional>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Told how much is done, 0 to 1, now and then; it may throw to give up.
using ShareDone = std::function<void(double share)>;

/// How far it is from each vertex through the body, against the normal, to where that is left [m].
/// At 2 * vertex + kind: from its skin (0) and from its walls (1), each along its own normal; -1
/// where there is none, or no way out. Reads the whole mesh. O(n log n) for usual shapes.
std::vector<float> surfaceThickness(const SurfaceMesh& mesh, const ShareDone& done = {});

}  // namespace kerf
