#include "sim/cut/cleanup/one_ring.h"

#include "sim/base/containers.h"

namespace kerf::cut {

namespace {

struct SectorTriangle {
    int slot;
    Vec3 reference;
};

bool isFeatureSpoke(const SurfaceMesh& mesh, const SharedStar& star, int h) {
    return star.edgeTo(mesh.firstCopy(mesh.target(h)))->isFeature();
}

/// The umbrella of a copy in sectors between features; without features it is a single one.
std::vector<SectorTriangle> sectorsAround(const SurfaceMesh& mesh, const SharedStar& star,
                                          int vertex) {
    std::vector<int> spokes;
    mesh.forEachOutgoing(vertex, [&](int h) { spokes.push_back(h); });
    const std::vector<bool> starts =
        mapped(spokes, [&](int h) { return isFeatureSpoke(mesh, star, h); });
    const int n = static_cast<int>(spokes.size());
    const auto firstFeature = std::find(starts.begin(), starts.end(), true);
    const int first =
        firstFeature == starts.end() ? 0 : static_cast<int>(firstFeature - starts.begin());
    std::vector<SectorTriangle> sectors;
    for (int i = 0; i < n;) {
        const int begin = i;
        Vec3 area = Vec3::Zero();
        do {
            area += areaNormal(cornersOf(mesh, spokes[(first + i) % n] / 3));
            ++i;
        } while (i < n && !starts[(first + i) % n]);
        for (int k = begin; k < i; ++k) {
            sectors.push_back({spokes[(first + k) % n] / 3, area});
        }
    }
    return sectors;
}

Triangle replaced(Triangle corners, int from, int to) {
    std::replace(corners.begin(), corners.end(), from, to);
    return corners;
}

bool hasCornerIn(const Triangle& corners, const std::vector<int>& vertices) {
    return std::any_of(corners.begin(), corners.end(), [&](int v) {
        return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
    });
}

}  // namespace

OneRing ringOfMove(const SurfaceMesh& mesh, const SharedStar& star, int vertex) {
    OneRing ring;
    ring.vertex = vertex;
    for (const SectorTriangle& sector : sectorsAround(mesh, star, vertex)) {
        ring.before.push_back(sector.slot);
        ring.after.push_back({mesh.triangle(sector.slot), sector.slot, sector.reference});
    }
    return ring;
}

OneRing ringOfMerge(const SurfaceMesh& mesh, const SharedStar& from, const SharedStar& to,
                    int vertex, std::vector<int> merged) {
    OneRing ring;
    ring.vertex = vertex;
    ring.merged = std::move(merged);
    for (const SectorTriangle& sector : sectorsAround(mesh, to, vertex)) {
        const Triangle& corners = mesh.triangle(sector.slot);
        ring.before.push_back(sector.slot);
        if (!hasCornerIn(corners, ring.merged)) {
            ring.after.push_back({corners, sector.slot, sector.reference});
        }
    }
    for (const int gone : ring.merged) {
        for (const SectorTriangle& sector : sectorsAround(mesh, from, gone)) {
            const Triangle& corners = mesh.triangle(sector.slot);
            if (!hasCornerIn(corners, {vertex})) {
                ring.before.push_back(sector.slot);
                ring.after.push_back(
                    {replaced(corners, gone, vertex), sector.slot, sector.reference});
            }
        }
    }
    return ring;
}

Corners cornersAfter(const SurfaceMesh& mesh, const OneRing& ring, const RingTriangle& triangle) {
    Corners corners;
    for (int i = 0; i < 3; ++i) {
        const int v = triangle.corners[i];
        corners[i] = v == ring.vertex ? ring.position : mesh.position(v);
    }
    return corners;
}

double edgeLength(const SurfaceMesh& mesh, int h) {
    return (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm();
}

std::array<int, 3> edgesByLength(const SurfaceMesh& mesh, int triangle) {
    std::array<int, 3> edges{3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
    std::stable_sort(edges.begin(), edges.end(),
                     [&](int a, int b) { return edgeLength(mesh, a) < edgeLength(mesh, b); });
    return edges;
}

bool isWallOnly(const SurfaceMesh& mesh, const std::vector<OneRing>& rings) {
    return std::all_of(rings.begin(), rings.end(), [&](const OneRing& ring) {
        return std::all_of(ring.before.begin(), ring.before.end(),
                           [&](int t) { return mesh.kind(t) == SurfaceKind::wall; });
    });
}

}  // namespace kerf::cut
