#include "sim/run/tear/weak_spot.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

/// The gradient of a triangle's deformation, in its plane.
Eigen::Matrix3d gradientOf(const Corners& rest, const Corners& now) {
    Eigen::Matrix<double, 3, 2> edges;
    edges << rest[1] - rest[0], rest[2] - rest[0];
    Eigen::Matrix<double, 3, 2> moved;
    moved << now[1] - now[0], now[2] - now[0];
    const Eigen::Matrix2d metric = edges.transpose() * edges;
    if (!(std::abs(metric.determinant()) > 1e-12 * metric.squaredNorm())) {
        return Eigen::Matrix3d::Zero();
    }
    return moved * metric.inverse() * edges.transpose();
}

/// Of a triangle and those at its corners, by area at rest: one alone may stretch for its shape.
Eigen::Matrix3d meanGradient(const SurfaceMesh& mesh, int t) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    double area = 0;
    for (const int v : mesh.triangle(t)) {
        mesh.forEachOutgoing(v, [&](int h) {
            const Corners rest = restCornersOf(mesh, SurfaceMesh::triangleOf(h));
            const double share = triangleArea(rest);
            sum += share * gradientOf(rest, cornersOf(mesh, SurfaceMesh::triangleOf(h)));
            area += share;
        });
    }
    return sum / area;
}

/// The largest principal stretch and its present direction.
struct Stretch {
    double size = 0;
    Vec3 direction = Vec3::Zero();
};

Stretch largestStretch(const Eigen::Matrix3d& gradient) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> stretches(gradient * gradient.transpose());
    return {std::sqrt(std::max(stretches.eigenvalues()[2], 0.0)), stretches.eigenvectors().col(2)};
}

bool counts(const SurfaceMesh& mesh, int t, const StrongPlaces& strong) {
    const Vec3& corner = mesh.restPosition(mesh.triangle(t)[0]);
    return mesh.kind(t) == SurfaceKind::skin &&
           std::ranges::none_of(strong.places, [&](const Vec3& place) {
               return (place - corner).norm() < strong.reach;
           });
}

}  // namespace

std::optional<WeakSpot> findWeakSpot(const SurfaceMesh& mesh, double least,
                                     const StrongPlaces& strong) {
    int weakest = -1;
    Stretch most{1 + least};
    for (const int t : livingTriangles(mesh)) {
        const Eigen::Matrix3d own = gradientOf(restCornersOf(mesh, t), cornersOf(mesh, t));
        if (largestStretch(own).size > most.size && counts(mesh, t, strong)) {
            const Stretch mean = largestStretch(meanGradient(mesh, t));
            weakest = mean.size > most.size ? t : weakest;
            most = mean.size > most.size ? mean : most;
        }
    }
    if (weakest < 0) {
        return std::nullopt;
    }
    const Corners now = cornersOf(mesh, weakest);
    const Vec3 normal = unitNormal<Vec3>(now[0], now[1], now[2]);
    return WeakSpot{(now[0] + now[1] + now[2]) / 3, normal,
                    normal.cross(most.direction).stableNormalized()};
}

}  // namespace kerf
