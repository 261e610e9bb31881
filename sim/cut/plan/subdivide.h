#pragma once

#include <vector>

#include "sim/cut/plan/intersections.h"

namespace kerf::cut {

/// On which side of the cut a new triangle lies.
enum class Sheet { surface, plus, minus };

/// A new triangle. Corners are vertices of the mesh, or mesh.vertexCount() + node.
struct NewTriangle {
    Triangle corners;
    Sheet sheet;
    SurfaceKind kind;
    int wallLabel;
};

/// The new number of a node: a V node is its mesh vertex.
int cornerId(const SurfaceMesh& mesh, const CutCurves& curves, int node);

/// All triangles that a step puts in the place of those that the strip meets.
struct Subdivision {
    std::vector<NewTriangle> triangles;
    std::vector<int> parents;   ///< by triangle: the one that it is a part of
    std::vector<int> replaced;  ///< ascending
    SubdivisionCounts patterns{};
};

/// Divides every surface triangle that the strip meets along its curve segments. The four
/// patterns of the paper come out as special cases of one constrained Delaunay triangulation in
/// barycentric coordinates. Lengths are those of corners at their common positions within
/// `closeDistance` [m], so that both walls of a slit divide alike. Throws StepFailure.
Subdivision subdivide(const SurfaceMesh& mesh, const CutCurves& curves, double closeDistance);

}  // namespace kerf::cut
