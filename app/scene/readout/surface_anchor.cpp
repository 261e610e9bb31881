#include "app/scene/readout/surface_anchor.h"

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

// How far from a triangle its material may lie at rest, of its longest edge: cuts and the cleaning
// up behind them move the surface a little.
constexpr double kSameMaterial = 0.05;

Vec3 blend(const Corners& corners, const Vec3& shares) {
    return shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
}

Vec3 sharesAt(const Corners& corners, const Vec3& point) {
    return closestWeights(point, corners[0], corners[1], corners[2]);
}

}  // namespace

SurfaceAnchor::SurfaceAnchor(const SurfaceMesh& mesh, const SurfacePoint& point)
    : triangle_(point.triangle),
      corners_(mesh.triangle(point.triangle)),
      kind_(mesh.kind(point.triangle)),
      shares_(sharesAt(cornersOf(mesh, point.triangle), point.position)),
      rest_(blend(restCornersOf(mesh, point.triangle), shares_)) {}

bool SurfaceAnchor::stands(const SurfaceMesh& mesh) const {
    return triangle_ < mesh.triangleSlots() && mesh.present(triangle_) &&
           mesh.triangle(triangle_) == corners_;
}

bool SurfaceAnchor::follow(const SurfaceMesh& mesh) {
    if (stands(mesh)) {
        return true;
    }
    const std::optional<int> next = triangleAtRest(mesh);
    if (next) {
        sitOn(mesh, *next);
    }
    return next.has_value();
}

/// Of the same kind, nearest to its place at rest; none where that is too far.
std::optional<int> SurfaceAnchor::triangleAtRest(const SurfaceMesh& mesh) const {
    std::optional<int> best;
    double nearest = 1e300;
    for (const int t : livingTriangles(mesh)) {
        if (mesh.kind(t) != kind_ || !mesh.present(t)) {
            continue;
        }
        const Corners corners = restCornersOf(mesh, t);
        const double away = (blend(corners, sharesAt(corners, rest_)) - rest_).norm();
        if (away < nearest && away <= kSameMaterial * longestEdge(corners)) {
            nearest = away;
            best = t;
        }
    }
    return best;
}

void SurfaceAnchor::sitOn(const SurfaceMesh& mesh, int triangle) {
    triangle_ = triangle;
    corners_ = mesh.triangle(triangle);
    shares_ = sharesAt(restCornersOf(mesh, triangle), rest_);
}

Vec3 SurfaceAnchor::position(const SurfaceMesh& mesh) const {
    mesh.bring(corners_);
    return blend(
        {mesh.position(corners_[0]), mesh.position(corners_[1]), mesh.position(corners_[2])},
        shares_);
}

}  // namespace kerf::app
