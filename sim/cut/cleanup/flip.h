#pragma once

#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// Flips the shared edge of half-edge h, all its copies, if that improves the triangles beside it,
/// keeps the volume, and changes no feature or locked edge. Returns whether.
bool flipEdge(Workspace& workspace, int h);

/// Flips the shared edge of half-edge h, all its copies, if that reduces self-intersections.
/// Triangles beside it may become worse, but no slivers. Returns whether.
bool flipEdgeApart(Workspace& workspace, int h);

}  // namespace kerf::cut
