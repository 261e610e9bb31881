#include "tests/support/self_intersections.h"

#include <Eigen/Geometry>

#include "sim/cut/exact/piercing.h"

namespace kerf::test {

namespace {

struct BoxedTriangle {
    int slot;
    Bounds bounds;
};

std::vector<BoxedTriangle> trianglesFromTheLeft(const SurfaceMesh& mesh) {
    std::vector<BoxedTriangle> boxes;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t)) {
            Bounds bounds;
            for (const int v : mesh.triangle(t)) {
                bounds.add(mesh.position(v));
            }
            boxes.push_back({t, bounds});
        }
    }
    std::sort(boxes.begin(), boxes.end(), [](const BoxedTriangle& a, const BoxedTriangle& b) {
        return std::pair(a.bounds.low.x(), a.slot) < std::pair(b.bounds.low.x(), b.slot);
    });
    return boxes;
}

bool isCorner(const Triangle& triangle, int v) {
    return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
}

/// Whether the inside of edge (u, v) passes through the inside of the triangle.
bool pierces(const SurfaceMesh& mesh, int u, int v, const Triangle& triangle) {
    if (isCorner(triangle, u) || isCorner(triangle, v)) {
        return false;
    }
    return cut::pierces(
        mesh.position(u), mesh.position(v),
        {mesh.position(triangle[0]), mesh.position(triangle[1]), mesh.position(triangle[2])});
}

bool anyEdgePierces(const SurfaceMesh& mesh, const Triangle& edges, const Triangle& triangle) {
    return pierces(mesh, edges[0], edges[1], triangle) ||
           pierces(mesh, edges[1], edges[2], triangle) ||
           pierces(mesh, edges[2], edges[0], triangle);
}

bool intersect(const SurfaceMesh& mesh, const Triangle& a, const Triangle& b) {
    return anyEdgePierces(mesh, a, b) || anyEdgePierces(mesh, b, a);
}

/// Outward unit normals of the walls at v.
std::vector<Vec3> wallNormals(const SurfaceMesh& mesh, int v) {
    std::vector<Vec3> normals;
    mesh.forEachOutgoing(v, [&](int h) {
        if (mesh.kind(h / 3) != SurfaceKind::wall) {
            return;
        }
        const Vec3 right = mesh.position(mesh.target(h)) - mesh.position(v);
        const Vec3 left = mesh.position(mesh.apex(h)) - mesh.position(v);
        const Vec3 normal = right.cross(left);
        if (normal.norm() > 0) {
            normals.push_back(normal.normalized());
        }
    });
    return normals;
}

/// A unit direction behind all planes; zero where the perceptron finds none in a few hundred
/// rounds, as at the end of a slit, which stays closed.
Vec3 inward(const std::vector<Vec3>& normals) {
    Vec3 direction = Vec3::Zero();
    for (const Vec3& n : normals) {
        direction -= n;
    }
    constexpr int kRounds = 300;
    constexpr double kMargin = 0.1;
    for (int round = 0; round < kRounds; ++round) {
        const auto worst = std::max_element(
            normals.begin(), normals.end(),
            [&](const Vec3& a, const Vec3& b) { return a.dot(direction) < b.dot(direction); });
        if (worst == normals.end() || worst->dot(direction) < -kMargin * direction.norm()) {
            break;
        }
        direction -= *worst;
    }
    const bool behindAll =
        std::ranges::all_of(normals, [&](const Vec3& n) { return n.dot(direction) < 0; });
    return behindAll ? Vec3(direction.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace

std::vector<std::pair<int, int>> selfIntersections(const SurfaceMesh& mesh) {
    const std::vector<BoxedTriangle> boxes = trianglesFromTheLeft(mesh);
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = i + 1;
             k < boxes.size() && boxes[k].bounds.low.x() <= boxes[i].bounds.high.x(); ++k) {
            if (boxes[i].bounds.overlaps(boxes[k].bounds) &&
                intersect(mesh, mesh.triangle(boxes[i].slot), mesh.triangle(boxes[k].slot))) {
                pairs.push_back(std::minmax(boxes[i].slot, boxes[k].slot));
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

SurfaceMesh opened(const SurfaceMesh& mesh, double distance) {
    SurfaceMesh result = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0 && mesh.copyGroup(v) >= 0) {
            result.setPosition(v, mesh.position(v) + distance * inward(wallNormals(mesh, v)));
        }
    }
    return result;
}

}  // namespace kerf::test
