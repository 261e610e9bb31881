#include "bench/lab/fem/loaded_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/files/import/model_source.h"
#include "sim/base/region.h"
#include "sim/mesh/closest_point.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/triangle.h"

namespace kerf::app {

namespace {

constexpr double kSamePlace = 1e-6;  ///< of coordinates, which Kerf has as floats [m]

Corners cornersAt(const std::vector<Vec3>& points, const Triangle& t) {
    return {points[t[0]], points[t[1]], points[t[2]]};
}

double volumeWithin(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
    double sum = 0;
    for (const Triangle& t : triangles) {
        const auto [a, b, c] = cornersAt(points, t);
        sum += tetrahedronVolume(a, b, c);
    }
    return sum;
}

/// Adds a vertex of the mesh where it is new. Returns its number.
int addVertex(LoadedSurface& surface, std::vector<int>& numbers, const SurfaceMesh& mesh, int v) {
    if (numbers[v] < 0) {
        numbers[v] = static_cast<int>(surface.rest.size());
        surface.rest.push_back(mesh.restPosition(v));
        surface.positions.push_back(mesh.position(v));
    }
    return numbers[v];
}

/// Pairs of copies that both belong to the surface.
void addLips(LoadedSurface& surface, const std::vector<int>& numbers, const SurfaceMesh& mesh) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (numbers[v] < 0 || mesh.copyGroup(v) < 0 || mesh.firstCopy(v) != v) {
            continue;
        }
        const std::vector<int>& copies = mesh.copiesOfGroup(mesh.copyGroup(v));
        if (copies.size() == 2 && numbers[copies[1]] >= 0) {
            surface.lips.push_back({numbers[copies[0]], numbers[copies[1]]});
        }
    }
}

/// Distance of each vertex that is used from the triangles of another surface [m].
std::vector<double> distances(const LoadedSurface& from, const LoadedSurface& to) {
    std::vector<int> ids(to.triangles.size());
    std::iota(ids.begin(), ids.end(), 0);
    const auto cornersOf = [&](int t) { return cornersAt(to.positions, to.triangles[t]); };
    NearestTriangle nearest(ids, cornersOf);
    std::vector<bool> isUsed(from.positions.size());
    for (const Triangle& t : from.triangles) {
        std::ranges::for_each(t, [&](int v) { isUsed[v] = true; });
    }
    std::vector<double> found;
    for (std::size_t v = 0; v < from.positions.size(); ++v) {
        if (isUsed[v]) {
            const Vec3& p = from.positions[v];
            const auto [a, b, c] = cornersOf(nearest.find(p));
            const Vec3 w = closestWeights(p, a, b, c);
            found.push_back((w[0] * a + w[1] * b + w[2] * c - p).norm());
        }
    }
    return found;
}

}  // namespace

LoadedSurface surfaceOf(const SurfaceMesh& mesh, int vertex) {
    const std::vector<int> pieces = findPieces(mesh).ofVertex;
    LoadedSurface surface;
    std::vector<int> numbers(mesh.vertexCount(), -1);
    for (const int t : livingTriangles(mesh)) {
        const Triangle& corners = mesh.triangle(t);
        if (pieces[corners[0]] == pieces[vertex]) {
            Triangle& own = surface.triangles.emplace_back();
            std::ranges::transform(corners, own.begin(),
                                   [&](int v) { return addVertex(surface, numbers, mesh, v); });
            surface.walls.push_back(mesh.kind(t) == SurfaceKind::wall);
        }
    }
    addLips(surface, numbers, mesh);
    return surface;
}

LoadedSurface surfaceOf(const SolidMesh& solid, const std::vector<Vec3>& positions,
                        const std::optional<double>& cut) {
    LoadedSurface surface{solid.nodes, positions, solid.skin, {}, solid.lips};
    for (const Triangle& t : solid.skin) {
        surface.walls.push_back(
            cut && std::ranges::all_of(t, [&](int v) { return solid.nodes[v].x() == *cut; }));
    }
    return surface;
}

double sagOf(const LoadedSurface& surface, const Bounds& probe) {
    double sum = 0;
    int count = 0;
    for (std::size_t v = 0; v < surface.rest.size(); ++v) {
        if (contains(Region(probe), surface.rest[v])) {
            sum += surface.rest[v].y() - surface.positions[v].y();
            ++count;
        }
    }
    return sum / count;
}

double sagOfLowest(const LoadedSurface& surface) {
    const auto lowest = [](const std::vector<Vec3>& points) {
        double y = 1e300;
        std::ranges::for_each(points, [&](const Vec3& p) { y = std::min(y, p.y()); });
        return y;
    };
    return lowest(surface.rest) - lowest(surface.positions);
}

double openingOf(const LoadedSurface& surface) {
    double top = -1e300;
    for (const Vec3& p : surface.rest) {
        top = std::max(top, p.y());
    }
    std::vector<std::pair<double, Vec3>> gaps;  // by z
    for (const auto& [a, b] : surface.lips) {
        if (surface.rest[a].y() > top - kSamePlace) {
            gaps.emplace_back(surface.rest[a].z(), surface.positions[b] - surface.positions[a]);
        }
    }
    std::ranges::sort(gaps, {}, &std::pair<double, Vec3>::first);
    const auto behind = std::ranges::upper_bound(gaps, 0.0, {}, &std::pair<double, Vec3>::first);
    if (behind == gaps.begin() || behind == gaps.end()) {
        return 0;
    }
    const auto before = behind - 1;
    const double share = -before->first / (behind->first - before->first);
    return ((1 - share) * before->second + share * behind->second).norm();
}

double volumeRatioOf(const LoadedSurface& surface) {
    return volumeWithin(surface.positions, surface.triangles) /
           volumeWithin(surface.rest, surface.triangles);
}

ShapeDeviation shapeDeviation(const LoadedSurface& a, const LoadedSurface& b) {
    std::vector<double> all = distances(a, b);
    const std::vector<double> others = distances(b, a);
    all.insert(all.end(), others.begin(), others.end());
    return {std::ranges::max(all),
            std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size())};
}

}  // namespace kerf::app
