#pragma once

#include "sim/mesh/deformation_field.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/run/parts/cohesive_zone.h"

namespace kerf {

/// The end of a slit: the line where both of its walls meet.
struct SlitEnd {
    std::vector<int> vertices;  ///< along it, at least two
    int label = 0;              ///< of the wall W+ beside it, as SurfaceMesh::wallLabel
};

/// The ends of all slits. O(triangles).
std::vector<SlitEnd> findSlitEnds(const SurfaceMesh& mesh);

/// From its first vertex to the last, at rest [m].
double restLength(const SurfaceMesh& mesh, const SlitEnd& end);

/// The axes of a slit's end, unit.
struct EndFrame {
    Vec3 along = Vec3::Zero();    ///< from its first vertex to the last
    Vec3 heading = Vec3::Zero();  ///< away from the slit, halfway between its walls
    Vec3 side = Vec3::Zero();     ///< towards the material of W+
};

/// By present or rest positions; none for an end without a direction.
std::optional<EndFrame> frameOf(const SurfaceMesh& mesh, const SlitEnd& end,
                                const VertexPositions& at);
/// At rest, heading as the slit does in the mean over its last `length` [m].
std::optional<EndFrame> restFrameOf(const SurfaceMesh& mesh, const SlitEnd& end, double length);

/// A way at rest from a vertex of an end as it is now, by the material about it [m].
Vec3 presentWay(const SurfaceMesh& mesh, const SlitEnd& end, int from, const Vec3& way);

/// A point of a wall near the end of its slit, at rest.
struct PointBehind {
    double distance = 0;  ///< from the end [m]
    double share = 0;     ///< along the end: 0 at its first vertex, 1 at the last
};

/// The points of W+ within `most` [m] of an end, without those on it, by vertex.
std::map<int, PointBehind> pointsBehind(const SurfaceMesh& mesh, const SlitEnd& end, double most);

/// What the end of a slit is opened by, in the mean over the length of the cohesive zone.
struct EndOpening {
    double atFirst = 0;       ///< at its first vertex, of what makes it advance
    double atLast = 0;        ///< at its last
    Vec3 way = Vec3::Zero();  ///< sum of the ways from W- to W+ [m]
    double most() const { return std::max(atFirst, atLast); }
};

/// Of a mesh with walls of edge length `edge` [m].
EndOpening openingOf(const SurfaceMesh& mesh, const CohesiveZone& cohesion, double edge,
                     const SlitEnd& end);

}  // namespace kerf
