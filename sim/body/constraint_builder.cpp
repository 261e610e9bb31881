#include "sim/body/constraint_builder.h"

#include <algorithm>
#include <optional>

#include "sim/body/dihedral.h"
#include "sim/body/rest_geometry.h"

namespace kerf {

namespace {

constexpr double kSliverHeight = 0.05;   // of the longest edge
constexpr double kLeastAreaShare = 0.1;  // A1 + A2 of an edge counts at least this share of L^2

/// Calls f(h) for one half-edge of each edge: the lower one.
template <class F>
void forEachEdge(const SurfaceMesh& mesh, F&& f) {
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.alive(h / 3) && h < mesh.twin(h)) {
            f(h);
        }
    }
}

// A strip of the shell beside the edge carries it: length L, cross-section t (A1 + A2) / L.
double edgeGeometry(double length, double area, double thickness) {
    const double square = length * length;
    const double counted = std::max(area, kLeastAreaShare * square);
    return counted > 0 ? square / (thickness * counted) : 1 / (kLeastAreaShare * thickness);
}

bool isSliver(const SurfaceMesh& mesh, int triangle) {
    const Triangle& t = mesh.triangle(triangle);
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 side = mesh.restPosition(t[(k + 1) % 3]) - mesh.restPosition(t[k]);
        longest = std::max(longest, side.squaredNorm());
    }
    return 2 * restArea(mesh, triangle) < kSliverHeight * longest;
}

std::vector<char> findSlivers(const SurfaceMesh& mesh) {
    std::vector<char> slivers(mesh.triangleSlots(), 0);
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        slivers[t] = mesh.alive(t) && isSliver(mesh, t);
    }
    return slivers;
}

std::optional<double> restAngle(const SurfaceMesh& mesh, int h) {
    const Vec3& x0 = mesh.restPosition(mesh.origin(h));
    const Vec3 edge = mesh.restPosition(mesh.target(h)) - x0;
    const Vec3 left = mesh.restPosition(mesh.apex(h)) - x0;
    const Vec3 right = mesh.restPosition(mesh.apex(mesh.twin(h))) - x0;
    const Dihedral<double> rest = dihedral<double>(edge, left, right);
    return rest.valid ? std::optional(rest.angle) : std::nullopt;
}

}  // namespace

std::vector<shared::EdgeConstraint> buildEdges(const SurfaceMesh& mesh, double thickness) {
    std::vector<shared::EdgeConstraint> edges;
    edges.reserve(3 * static_cast<std::size_t>(mesh.aliveTriangles()) / 2);
    forEachEdge(mesh, [&](int h) {
        const int a = mesh.origin(h);
        const int b = mesh.target(h);
        const double length = (mesh.restPosition(b) - mesh.restPosition(a)).norm();
        const double area = restArea(mesh, h / 3) + restArea(mesh, mesh.twin(h) / 3);
        edges.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                         static_cast<float>(length),
                         static_cast<float>(edgeGeometry(length, area, thickness))});
    });
    return edges;
}

std::vector<shared::BendConstraint> buildBends(const SurfaceMesh& mesh, double thickness) {
    // Bending stiffness of a plate, Poisson's ratio 0.3: about 0.3 E t^3 / 12.
    const double geometry = 1 / (0.3 * thickness * thickness * thickness / 12);
    const std::vector<char> sliver = findSlivers(mesh);
    std::vector<shared::BendConstraint> bends;
    bends.reserve(3 * static_cast<std::size_t>(mesh.aliveTriangles()) / 2);
    forEachEdge(mesh, [&](int h) {
        const int g = mesh.twin(h);
        if (sliver[h / 3] || sliver[g / 3] || mesh.apex(h) == mesh.apex(g)) {
            return;
        }
        if (const std::optional<double> angle = restAngle(mesh, h)) {
            bends.push_back({static_cast<std::uint32_t>(mesh.origin(h)),
                             static_cast<std::uint32_t>(mesh.target(h)),
                             static_cast<std::uint32_t>(mesh.apex(h)),
                             static_cast<std::uint32_t>(mesh.apex(g)), static_cast<float>(*angle),
                             static_cast<float>(geometry)});
        }
    });
    return bends;
}

}  // namespace kerf
