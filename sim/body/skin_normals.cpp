#include "sim/body/skin_normals.h"

#include <numeric>

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

SkinNormals::SkinNormals(const SurfaceMesh& uncut) : uncutVertices_(uncut.vertexCount()) {
    normals_.reserve(uncutVertices_);
    for (int v = 0; v < uncutVertices_; ++v) {
        normals_.push_back(restNormal(uncut, v).direction);
    }
}

void SkinNormals::follow(const SurfaceMesh& mesh, int firstNew, std::span<const Triangle> old) {
    normals_.resize(mesh.vertexCount(), Vec3::Zero());
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
        normals_[v] =
            (w[0] * normals_[old[i][0]] + w[1] * normals_[old[i][1]] + w[2] * normals_[old[i][2]])
                .normalized();
    }
}

Vec3 SkinNormals::ofCut(const SurfaceMesh& mesh, int vertex) const {
    const Kinds kinds = kindsAround(mesh, vertex);
    const bool isNew = vertex >= uncutVertices_;
    return kinds.skin && (isNew || kinds.wall) ? normals_[vertex] : Vec3::Zero();
}

}  // namespace kerf
