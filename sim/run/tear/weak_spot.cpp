#include "sim/run/tear/weak_spot.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

/// The largest principal stretch of a triangle and its present direction.
struct Stretch {
    double size = 0;
    Vec3 direction = Vec3::Zero();
};

Stretch largestStretch(const Corners& rest, const Corners& now) {
    Eigen::Matrix<double, 3, 2> edges;
    edges << rest[1] - rest[0], rest[2] - rest[0];
    Eigen::Matrix<double, 3, 2> moved;
    moved << now[1] - now[0], now[2] - now[0];
    const Eigen::Matrix2d metric = edges.transpose() * edges;
    if (!(std::abs(metric.determinant()) > 1e-12 * metric.squaredNorm())) {
        return {};
    }
    // In edges: moved = gradient * edges.
    const Eigen::Matrix3d gradient = moved * metric.inverse() * edges.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> stretches(gradient * gradient.transpose());
    return {std::sqrt(std::max(stretches.eigenvalues()[2], 0.0)), stretches.eigenvectors().col(2)};
}

/// Of a triangle and those at its corners, by area at rest: one alone may stretch for its shape.
double meanAround(const SurfaceMesh& mesh, int t, const std::vector<Stretch>& stretches) {
    double sum = 0;
    double area = 0;
    for (const int v : mesh.triangle(t)) {
        mesh.forEachOutgoing(v, [&](int h) {
            const int u = SurfaceMesh::triangleOf(h);
            const double share = triangleArea(restCornersOf(mesh, u));
            sum += share * stretches[u].size;
            area += share;
        });
    }
    return sum / area;
}

bool counts(const SurfaceMesh& mesh, int t, const StrongPlaces& strong) {
    const Vec3 corner = mesh.restPosition(mesh.triangle(t)[0]);
    return mesh.kind(t) == SurfaceKind::skin &&
           std::ranges::none_of(strong.places, [&](const Vec3& place) {
               return (place - corner).norm() < strong.reach;
           });
}

}  // namespace

std::optional<WeakSpot> findWeakSpot(const SurfaceMesh& mesh, double least,
                                     const StrongPlaces& strong) {
    std::vector<Stretch> stretches(mesh.triangleSlots());
    for (const int t : livingTriangles(mesh)) {
        stretches[t] = largestStretch(restCornersOf(mesh, t), cornersOf(mesh, t));
    }
    int weakest = -1;
    double most = 1 + least;
    for (const int t : livingTriangles(mesh)) {
        if (stretches[t].size > most && counts(mesh, t, strong)) {
            if (const double mean = meanAround(mesh, t, stretches); mean > most) {
                most = mean;
                weakest = t;
            }
        }
    }
    if (weakest < 0) {
        return std::nullopt;
    }
    const Corners now = cornersOf(mesh, weakest);
    const Vec3 normal = unitNormal<Vec3>(now[0], now[1], now[2]);
    return WeakSpot{(now[0] + now[1] + now[2]) / 3, normal,
                    normal.cross(stretches[weakest].direction).stableNormalized()};
}

}  // namespace kerf
