#pragma once

#include "sim/cut/plan/curves/cut_curves.h"

namespace kerf::cut {

/// The part of the new surface to which a new triangle belongs: divided old surface, or the wall on
/// the side W+ or W- of the cut.
enum class CutSide { surface, plus, minus };

/// A triangle that a step makes.
struct NewTriangle {
    Triangle corners;  ///< vertices of the mesh, or mesh.vertexCount() + node
    CutSide side;      ///< the part of the new surface
    SurfaceKind kind;  ///< skin or wall
    int wallLabel;     ///< as SurfaceMesh::wallLabel
};

/// The corner that stands for a node (NewTriangle::corners): a V node is its mesh vertex.
int cornerId(const SurfaceMesh& mesh, const CutCurves& curves, int node);

/// All triangles that replace those that the strip meets.
struct Subdivision {
    std::vector<NewTriangle> triangles;  ///< parent after parent
    std::vector<int> parents;            ///< slot of which each triangle is a part
    std::vector<int> replaced;           ///< slots of all parents, ascending
    SubdivisionCounts patterns{};        ///< parents by how they are divided
};

/// Divides every surface triangle that the strip meets along its curve segments. The four patterns
/// of the paper are special cases of one constrained Delaunay triangulation in barycentric
/// coordinates. Lengths are those of corners at their common positions within `closeDistance` [m],
/// so that both walls of a slit divide alike. Throws StepFailure.
Subdivision subdivide(const SurfaceMesh& mesh, const CutCurves& curves, double closeDistance);

}  // namespace kerf::cut
