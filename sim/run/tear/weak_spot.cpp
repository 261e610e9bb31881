#include "sim/run/tear/weak_spot.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

// Edges: half the length of a notch, how high above the skin it begins, how deep it goes.
constexpr double kHalfLength = 1;
constexpr double kAbove = 0.3;
constexpr double kDepth = 0.8;

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

bool counts(const SurfaceMesh& mesh, int t, const StrongPlaces& strong) {
    const Triangle& corners = mesh.triangle(t);
    const auto isHeld = [&](int v) {
        return std::ranges::binary_search(strong.held, static_cast<std::uint32_t>(v));
    };
    const Vec3 middle = mesh.restPosition(corners[0]);
    return mesh.kind(t) == SurfaceKind::skin && std::ranges::none_of(corners, isHeld) &&
           std::ranges::none_of(strong.ends, [&](const Vec3& end) {
               return (end - middle).norm() < strong.nearEnds;
           });
}

}  // namespace

std::optional<WeakSpot> findWeakSpot(const SurfaceMesh& mesh, double least,
                                     const StrongPlaces& strong) {
    std::optional<WeakSpot> spot;
    double most = 1 + least;
    for (const int t : livingTriangles(mesh)) {
        const Corners now = cornersOf(mesh, t);
        const Stretch stretch = largestStretch(restCornersOf(mesh, t), now);
        if (stretch.size > most && counts(mesh, t, strong)) {
            most = stretch.size;
            const Vec3 normal = unitNormal<Vec3>(now[0], now[1], now[2]);
            spot = {(now[0] + now[1] + now[2]) / 3, normal,
                    normal.cross(stretch.direction).stableNormalized()};
        }
    }
    return spot;
}

Notch notchAt(const WeakSpot& spot, double edge) {
    const Vec3 half = kHalfLength * edge * spot.along;
    const Vec3 above = spot.at + kAbove * edge * spot.normal;
    const Vec3 below = spot.at - kDepth * edge * spot.normal;
    return {{above - half, above + half}, {below - half, below + half}};
}

}  // namespace kerf
