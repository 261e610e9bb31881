#include "sim/body/constraint_lists.h"

#include "sim/body/rest_geometry.h"
#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

constexpr double kSliverHeight = 0.05;   // of the longest edge
constexpr double kLeastAreaShare = 0.1;  // A1 + A2 of an edge counts at least this share of L^2

// A strip of the shell beside the edge carries it: length L, cross-section t (A1 + A2) / L. So does
// one of the skin, of the volume `ofSkin`.
double edgeGeometry(double length, double area, double thickness, double ofSkin) {
    const double square = length * length;
    const double counted = std::max(area, kLeastAreaShare * square);
    return counted > 0 ? square / (thickness * counted + ofSkin)
                       : 1 / (kLeastAreaShare * thickness);
}

double presentArea(const SurfaceMesh& mesh, int triangle) {
    return mesh.absent(triangle) ? 0.0 : restArea(mesh, triangle);
}

/// 0 of walls.
double skinArea(const SurfaceMesh& mesh, int triangle) {
    return mesh.kind(triangle) == SurfaceKind::skin ? presentArea(mesh, triangle) : 0.0;
}

bool isSliver(const SurfaceMesh& mesh, int triangle) {
    const Corners rest = restCornersOf(mesh, triangle);
    return areaNormal(rest).norm() < kSliverHeight * longestEdgeSquare(rest);
}

}  // namespace

EdgeConstraint edgeConstraint(const SurfaceMesh& mesh, int h, double thickness, double skin) {
    const int a = mesh.origin(h);
    const int b = mesh.target(h);
    const double length = (mesh.restPosition(b) - mesh.restPosition(a)).norm();
    const double area = presentArea(mesh, h / 3) + presentArea(mesh, mesh.twin(h) / 3);
    const double ofSkin = skin * (skinArea(mesh, h / 3) + skinArea(mesh, mesh.twin(h) / 3));
    return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
            static_cast<float>(length),
            static_cast<float>(edgeGeometry(length, area, thickness, ofSkin))};
}

std::optional<BendConstraint> bendConstraint(const SurfaceMesh& mesh, int h, double thickness) {
    const int g = mesh.twin(h);
    if (mesh.absent(h / 3) || mesh.absent(g / 3)) {
        return std::nullopt;
    }
    if (isSliver(mesh, h / 3) || isSliver(mesh, g / 3) || mesh.apex(h) == mesh.apex(g)) {
        return std::nullopt;
    }
    const std::optional<double> angle = restEdgeAngle(mesh, h);
    if (!angle) {
        return std::nullopt;
    }
    // Bending stiffness of a plate, Poisson's ratio 0.3: about 0.3 E t^3 / 12.
    const double geometry = 1 / (0.3 * thickness * thickness * thickness / 12);
    return BendConstraint{static_cast<std::uint32_t>(mesh.origin(h)),
                          static_cast<std::uint32_t>(mesh.target(h)),
                          static_cast<std::uint32_t>(mesh.apex(h)),
                          static_cast<std::uint32_t>(mesh.apex(g)),
                          static_cast<float>(*angle),
                          static_cast<float>(geometry)};
}

}  // namespace kerf
