#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bench/lab/fem/solid_mesh.h"
#include "sim/base/math.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The surface of a body that is held and loaded, as it rests unloaded and as it lies then: of
/// Kerf's body, or of the finite elements beside it.
struct LoadedSurface {
    std::vector<Vec3> rest;           ///< per vertex, unloaded [m]
    std::vector<Vec3> positions;      ///< per vertex, under the load [m]
    std::vector<Triangle> triangles;  ///< outward
    std::vector<bool> walls;          ///< per triangle: a cut made it
    /// Pairs of vertices that were one point before the cut, on either side of it.
    std::vector<std::array<int, 2>> lips;
};

/// The piece of a body that holds a vertex.
LoadedSurface surfaceOf(const SurfaceMesh& mesh, int vertex);
/// Finite elements with their nodes at these places, cut along the plane x = `cut`.
LoadedSurface surfaceOf(const SolidMesh& solid, const std::vector<Vec3>& positions,
                        const std::optional<double>& cut);

/// How far the points that lie in a box at rest have come down, in the mean [m].
double sagOf(const LoadedSurface& surface, const Bounds& probe);
/// How far the lowest point has come down [m].
double sagOfLowest(const LoadedSurface& surface);
/// How far the lips of a cut stand apart on the upper side of the body, at z = 0 [m]; 0 without a
/// cut.
double openingOf(const LoadedSurface& surface);
/// Volume under the load over that at rest.
double volumeRatioOf(const LoadedSurface& surface);

/// How far two surfaces are from each other under their loads.
struct ShapeDeviation {
    double largest = 0;  ///< of a vertex of either from the other one (Hausdorff) [m]
    double mean = 0;     ///< of all vertices of both [m]
};
ShapeDeviation shapeDeviation(const LoadedSurface& a, const LoadedSurface& b);

}  // namespace kerf::app
