#include "sim/body/skin_normals.h"

#include <numeric>
#include <utility>

#include "sim/body/rest_geometry.h"
#include "sim/mesh/closest_point.h"
#include "sim/mesh/nearest_triangle.h"

namespace kerf {

namespace {

/// Which kinds of triangles lie around a vertex.
struct Kinds {
    bool skin = false;
    bool wall = false;
};

Kinds kindsAround(const SurfaceMesh& mesh, int vertex) {
    Kinds kinds;
    mesh.forEachOutgoing(vertex, [&](int h) {
        (mesh.kind(h / 3) == SurfaceKind::skin ? kinds.skin : kinds.wall) = true;
    });
    return kinds;
}

}  // namespace

SkinNormals::SkinNormals(const SurfaceMesh& uncut) {
    std::vector<Vec3> normals;
    normals.reserve(uncut.vertexCount());
    for (int v = 0; v < uncut.vertexCount(); ++v) {
        normals.push_back(restNormal(uncut, v).direction);
    }
    uncut_ = std::make_shared<const std::vector<Vec3>>(std::move(normals));
}

const Vec3& SkinNormals::normal(int vertex) const {
    return vertex < uncutVertices() ? (*uncut_)[vertex] : later_[vertex - uncutVertices()];
}

void SkinNormals::follow(const SurfaceMesh& mesh, int firstNew, std::span<const Triangle> old) {
    later_.resize(mesh.vertexCount() - uncutVertices(), Vec3::Zero());
    if (old.empty()) {
        return;
    }
    const auto cornersOf = [&](int i) {
        const auto [a, b, c] = old[i];
        return std::array{mesh.restPosition(a), mesh.restPosition(b), mesh.restPosition(c)};
    };
    std::vector<int> ids(old.size());
    std::iota(ids.begin(), ids.end(), 0);
    NearestTriangle nearest(ids, cornersOf);
    for (int v = firstNew; v < mesh.vertexCount(); ++v) {
        if (!kindsAround(mesh, v).skin) {
            continue;
        }
        const Vec3& p = mesh.restPosition(v);
        const int i = nearest.find(p);
        const auto [a, b, c] = cornersOf(i);
        const Vec3 w = closestWeights(p, a, b, c);
        const Vec3 sum =
            w[0] * normal(old[i][0]) + w[1] * normal(old[i][1]) + w[2] * normal(old[i][2]);
        later_[v - uncutVertices()] = sum.normalized();
    }
}

Vec3 SkinNormals::ofCut(const SurfaceMesh& mesh, int vertex) const {
    const Kinds kinds = kindsAround(mesh, vertex);
    const bool isNew = vertex >= uncutVertices();
    return kinds.skin && (isNew || kinds.wall) ? normal(vertex) : Vec3::Zero();
}

}  // namespace kerf
