#pragma once

#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// Improves a sliver without changing topology: moves a vertex away from the opposite edge, or the
/// ends of the shortest edge apart, in a direction that keeps the volume of every piece. Returns
/// whether.
bool slideVertex(Workspace& workspace, int triangle);

}  // namespace kerf::cut
