#pragma once

#include <map>
#include <optional>
#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// The end of a slit: the line where both of its walls meet.
struct SlitEnd {
    std::vector<int> vertices;  ///< along it, at least two
    int label = 0;              ///< of the wall W+ beside it, as SurfaceMesh::wallLabel
};

/// The ends of all slits. O(triangles).
std::vector<SlitEnd> findSlitEnds(const SurfaceMesh& mesh);

/// The present axes of a slit's end, unit.
struct EndFrame {
    Vec3 along = Vec3::Zero();    ///< from its first vertex to the last
    Vec3 heading = Vec3::Zero();  ///< away from the slit, halfway between its walls
    Vec3 side = Vec3::Zero();     ///< towards the material of W+
};

/// None for an end without a direction.
std::optional<EndFrame> frameOf(const SurfaceMesh& mesh, const SlitEnd& end);

/// A point of a wall near the end of its slit, at rest.
struct PointBehind {
    double distance = 0;  ///< from the end [m]
    double share = 0;     ///< along the end: 0 at its first vertex, 1 at the last
};

/// The points of W+ within `most` [m] of an end, without those on it, by vertex.
std::map<int, PointBehind> pointsBehind(const SurfaceMesh& mesh, const SlitEnd& end, double most);

}  // namespace kerf
