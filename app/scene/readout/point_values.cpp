#include "app/scene/readout/point_values.h"

#include <Eigen/Dense>
#include <cmath>

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

/// Strain and change of area, each times the area at rest, and that area.
using Sums = Vec3;

/// Squared lengths of two sides, and their product.
Eigen::Matrix2d gram(const Corners& c) {
    Eigen::Matrix<double, 3, 2> sides;
    sides << c[1] - c[0], c[2] - c[0];
    return sides.transpose() * sides;
}

Sums strainsOf(const SurfaceMesh& mesh, int triangle) {
    const Corners restCorners = restCornersOf(mesh, triangle);
    const Eigen::Matrix2d rest = gram(restCorners);
    const Eigen::Matrix2d now = gram(cornersOf(mesh, triangle));
    if (!(rest.determinant() > 0)) {
        return Sums::Zero();
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> stretches(now, rest);
    const auto strains = stretches.eigenvalues().cwiseMax(0).cwiseSqrt().array() - 1;
    const double area = std::sqrt(std::max(now.determinant(), 0.0) / rest.determinant()) - 1;
    return triangleArea(restCorners) * Sums(strains.abs().maxCoeff(), area, 1);
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
