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

/// The largest principal stretch and its present direction.
struct Stretch {
    double size = 0;
    Vec3 direction = Vec3::Zero();
};

Stretch largestStretch(const Eigen::Matrix3d& gradient) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> stretches(gradient * gradient.transpose());
    return {std::sqrt(std::max(stretches.eigenvalues()[2], 0.0)), stretches.eigenvectors().col(2)};
}

// A cohesive zone is 3.5 edges long or longer (kEdgesInZone). The strength of a body is that of the
// mean over 0.7 of it, the line method of critical distances (Taylor, 2007).
constexpr int kRings = 3;

/// The vertices within so many edges of a triangle.
std::set<int> verticesAround(const SurfaceMesh& mesh, int t) {
    std::set<int> around(mesh.triangle(t).begin(), mesh.triangle(t).end());
    for (int ring = 1; ring < kRings; ++ring) {
        for (const int v : std::vector<int>(around.begin(), around.end())) {
            mesh.forEachOutgoing(v, [&](int h) { around.insert(mesh.target(h)); });
        }
    }
    return around;
}

/// In the mean over the skin around a triangle, along directions in its plane. Where the skin is
/// curved the mean at rest is shorter too.
Stretch meanStretch(const SurfaceMesh& mesh, int t) {
    const Corners own = restCornersOf(mesh, t);
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = (own[1] - own[0]).stableNormalized();
    plane.col(1) = unitNormal<Vec3>(own[0], own[1], own[2]).cross(plane.col(0));
    Eigen::Matrix<double, 3, 2> atRest = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Matrix<double, 3, 2> now = atRest;
    for (const int v : verticesAround(mesh, t)) {
        mesh.forEachOutgoing(v, [&](int h) {
            const Corners rest = restCornersOf(mesh, SurfaceMesh::triangleOf(h));
            const double area = triangleArea(rest);
            atRest += area * gradientOf(rest, rest) * plane;
            now += area * gradientOf(rest, cornersOf(mesh, SurfaceMesh::triangleOf(h))) * plane;
        });
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> stretches(
        now.transpose() * now, atRest.transpose() * atRest);
    return {std::sqrt(std::max(stretches.eigenvalues()[1], 0.0)),
            (now * stretches.eigenvectors().col(1)).stableNormalized()};
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
            const Stretch mean = meanStretch(mesh, t);
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
