#pragma once

#include <optional>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Area of a living triangle in the rest shape [m^2].
double restArea(const SurfaceMesh& mesh, int triangle);

/// A third of the rest area of the triangles around each vertex [m^2], shape [vertexCount].
std::vector<double> restVertexAreas(const SurfaceMesh& mesh);

/// Mean rest edge length of the living triangles [m].
double meanRestEdgeLength(const SurfaceMesh& mesh);

/// The outward normal of a vertex in the rest shape, weighted by the angles of its triangles.
struct VertexNormal {
    Vec3 direction = Vec3::Zero();  ///< unit; zero where the triangles cancel
    /// Length of the weighted sum over the sum of the angles: 1 where flat, near 0 at the front of
    /// a slit, whose two walls face each other.
    double flatness = 0;
};
VertexNormal restNormal(const SurfaceMesh& mesh, int vertex);

/// The dihedral angle at a half-edge [rad], flat 0, convex > 0: now and at rest. None if a triangle
/// beside it is degenerate.
std::optional<double> edgeAngle(const SurfaceMesh& mesh, int h);
std::optional<double> restEdgeAngle(const SurfaceMesh& mesh, int h);

}  // namespace kerf
