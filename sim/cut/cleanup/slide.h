#pragma once

#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// Makes a sliver better without changing topology: pushes a vertex away from the opposite edge, or
/// the ends of the shortest edge apart, in a direction in which no piece's volume changes. Returns
/// whether.
bool slideVertex(Workspace& workspace, int triangle);

}  // namespace kerf::cut
