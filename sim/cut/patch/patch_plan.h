#pragma once

#include "sim/cut/patch/wound.h"

namespace kerf::cut {

/// A patch to close a wound on both sides alike.
struct PatchPlan {
    std::vector<WoundEdge> rim;           ///< node i lies where edge i of W+ starts
    std::vector<std::vector<int>> inner;  ///< the other nodes: each the mean of earlier nodes
    std::vector<Triangle> triangles;      ///< nodes, in the orientation of W+
};

/// Plans the paper's patch, in the rest shape: the loops of the wound are laid out in their mean
/// plane (the largest is the outer one, the others are holes in it) and triangulated as a wall is.
/// Then the triangles are refined until they match the edges around the rim (Liepa, "Filling Holes
/// in Meshes", 2003). Edges that the surface has already are divided. Throws StepFailure where the
/// wound has no such patch: it ends in the body, has no mirror, or is so curved that the patch
/// would fold. `h`: edge length of walls [m].
PatchPlan planPatch(const SurfaceMesh& mesh, const Wound& wound, double h);

}  // namespace kerf::cut
