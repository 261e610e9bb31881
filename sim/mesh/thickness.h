#pragma once

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Called with the share done, 0 to 1; may throw to cancel.
using ShareDone = std::function<void(double share)>;

/// The distance from each vertex through the body, against the normal, to the exit [m]. At 2 *
/// vertex + kind: from its skin (0) and from its walls (1), each along its own normal; -1
/// for none. At the rim of a cut and without an exit it is that of the neighbours.
/// Reads the whole mesh. O(n log n) for usual shapes.
std::vector<float> surfaceThickness(const SurfaceMesh& mesh, const ShareDone& done = {});

}  // namespace kerf
