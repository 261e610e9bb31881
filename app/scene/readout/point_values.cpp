#include "app/scene/readout/point_values.h"

#include "sim/mesh/triangle_quality.h"

namespace kerf::app {
namespace {

/// Strain and change of area, each times the area at rest, and that area.
using Sums = Vec3;

Sums strainsOf(const SurfaceMesh& mesh, int triangle) {
    const Corners rest = restCornersOf(mesh, triangle);
    const Corners now = cornersOf(mesh, triangle);
    const double area = triangleArea(rest);
    if (!(area > 0)) {
        return Sums::Zero();
    }
    return area * Sums(largestStrain(rest, now), triangleArea(now) / area - 1, 1);
}

/// Around a vertex, over one kind of surface.
Sums strainsAround(const SurfaceMesh& mesh, int vertex, SurfaceKind kind) {
    Sums sums = Sums::Zero();
    mesh.forEachOutgoing(vertex, [&](int h) {
        if (mesh.kind(h / 3) == kind && mesh.present(h / 3)) {
            sums += strainsOf(mesh, h / 3);
        }
    });
    return sums;
}

}  // namespace

PointValues valuesAt(const SurfaceMesh& mesh, const SurfaceAnchor& anchor) {
    const Triangle& corners = mesh.triangle(anchor.triangle());
    bringAround(mesh, anchor.triangle());
    PointValues values;
    Vec3 velocity = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double share = anchor.shares()[k];
        const Sums sums = strainsAround(mesh, corners[k], mesh.kind(anchor.triangle()));
        values.strain += share * sums[0] / sums[2];
        values.area += share * sums[1] / sums[2];
        velocity += share * mesh.velocity(corners[k]);
    }
    values.way = (anchor.position(mesh) - anchor.rest()).norm();
    values.speed = velocity.norm();
    return values;
}

}  // namespace kerf::app
