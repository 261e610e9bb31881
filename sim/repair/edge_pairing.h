#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::repair {

/// Turns triangles so that both at an edge of two face the same way, as far as the surface has two
/// sides. The larger part of each connected patch stays as it is. Returns how many were turned.
int orientAlike(TriangleSoup& soup);

/// Where partBranches() parted a surface.
struct PartedSurface {
    int edges = 0;
    int vertices = 0;
};

/// Gives each triangle at an edge at most one partner: where there are more than two, those that
/// the surface joins elsewhere, or those with material between them. What then hangs together in a
/// point or a line alone gets vertices of its own at the same place; see moveApart().
PartedSurface partBranches(TriangleSoup& soup);

}  // namespace kerf::repair
