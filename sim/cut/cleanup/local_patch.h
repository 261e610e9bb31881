#pragma once

#include <vector>

#include "sim/cut/cleanup/material.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

/// A triangle as it would be after an operation.
struct PatchTriangle {
    Triangle corners;
    int slot;  ///< in the mesh
    /// Area vector of the sector between two features around its old corner [m^2].
    Vec3 reference;
};

/// What an operation does around one vertex: everything in `before` becomes `after`, in which
/// `vertex` alone lies elsewhere.
struct Patch {
    int vertex = -1;
    std::vector<int> merged;  ///< vertices that become `vertex`
    bool joins = false;       ///< `vertex` keeps its triangles and becomes a copy of the target
    std::vector<int> before;  ///< slots
    std::vector<PatchTriangle> after;
    Vec3 position = Vec3::Zero();
    Vec3 rest = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
};

/// The triangles around `star`'s copy `vertex`, which moves.
Patch patchOfMove(const SurfaceMesh& mesh, const MaterialStar& star, int vertex);

/// The triangles around `vertex`, a copy of `to`, and around those copies of `from` that merge
/// into it.
Patch patchOfMerge(const SurfaceMesh& mesh, const MaterialStar& from, const MaterialStar& to,
                   int vertex, std::vector<int> merged);

/// Corners of a triangle of the patch, at their places after the operation.
Corners cornersAfter(const SurfaceMesh& mesh, const Patch& patch, const PatchTriangle& triangle);
double edgeLength(const SurfaceMesh& mesh, int h);
/// Half-edges of a triangle, the shortest first.
std::array<int, 3> edgesByLength(const SurfaceMesh& mesh, int triangle);

bool isWallOnly(const SurfaceMesh& mesh, const std::vector<Patch>& patches);

}  // namespace kerf::cut
