#pragma once

#include "sim/mesh/triangle_soup.h"

namespace kerf::app {

/// Reorients triangles consistently, as far as the surface is orientable. The larger part of each
/// connected patch is unchanged. Returns how many were reversed.
int orientAlike(TriangleSoup& soup);

/// Where partBranches() separated a surface.
struct PartedSurface {
    int edges = 0;
    int vertices = 0;
};

/// Gives each triangle at an edge at most one partner: if there are more than two, those that the
/// surface joins elsewhere, or those with material between them. Parts then connected only in a
/// point or a line get separate vertices at the same place; see moveApart().
PartedSurface partBranches(TriangleSoup& soup);

}  // namespace kerf::app
