#include "sim/mesh/corner_uvs.h"

#include <cassert>

#include "sim/mesh/closest_point.h"
#include "sim/mesh/nearest_triangle.h"
#include "sim/mesh/surface_mesh.h"
#include "sim/mesh/triangle.h"

namespace kerf {
namespace {

constexpr int kMaxWalk = 16;        // triangles from the middle of a new one to its corner
constexpr double kOutside = -1e-6;  // a weight below this is outside

CornerUvs noUvs() {
    return {Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()};
}

/// Finds places on the uncut skin and their texture coordinates.
class UvLookup {
  public:
    UvLookup(const SurfaceMesh& uncut, const std::vector<CornerUvs>& uvs)
        : mesh_(uncut),
          uvs_(uvs),
          triangles_(livingTriangles(uncut), [this](int t) { return restCornersOf(mesh_, t); }) {}

    CornerUvs uvsOf(const Triangle& corners, const SurfaceMesh& cut) {
        const Vec3& a = cut.restPosition(corners[0]);
        const Vec3& b = cut.restPosition(corners[1]);
        const Vec3& c = cut.restPosition(corners[2]);
        const int middle = triangles_.find((a + b + c) / 3);
        return {at(middle, a), at(middle, b), at(middle, c)};
    }

  private:
    /// From triangle t over edges that are no seams to where p lies.
    Eigen::Vector2f at(int t, const Vec3& p) const {
        for (int walked = 0; walked < kMaxWalk; ++walked) {
            const Vec3 weights = planeWeights(t, p);
            int least = 0;
            weights.minCoeff(&least);
            const int across = neighbour(t, (least + 1) % 3);
            if (weights[least] >= kOutside || across < 0) {
                break;
            }
            t = across;
        }
        const auto [a, b, c] = restCornersOf(mesh_, t);
        return blend(t, closestWeights(p, a, b, c));
    }

    Eigen::Vector2f blend(int t, const Vec3& weights) const {
        const Eigen::Vector3f w = weights.cast<float>();
        return w[0] * uvs_[t][0] + w[1] * uvs_[t][1] + w[2] * uvs_[t][2];
    }

    /// Barycentric, of the foot of p in the plane of t.
    Vec3 planeWeights(int t, const Vec3& p) const {
        const auto [a, b, c] = restCornersOf(mesh_, t);
        const Vec3 normal = areaNormal(a, b, c);
        const double area = normal.squaredNorm();
        if (area == 0) {
            return Vec3::Constant(1.0 / 3);
        }
        const double v = areaNormal(a, p, c).dot(normal) / area;
        const double w = areaNormal(a, b, p).dot(normal) / area;
        return {1 - v - w, v, w};
    }

    /// Over the edge that begins at a corner; -1 where that is a seam.
    int neighbour(int t, int corner) const {
        const int h = 3 * t + corner;
        const int g = mesh_.twin(h);
        const CornerUvs& here = uvs_[t];
        const CornerUvs& there = uvs_[g / 3];
        const bool seam =
            here[corner] != there[(g % 3 + 1) % 3] || here[(corner + 1) % 3] != there[g % 3];
        return seam ? -1 : g / 3;
    }

    const SurfaceMesh& mesh_;
    const std::vector<CornerUvs>& uvs_;
    NearestTriangle triangles_;
};

/// No cut has touched it: its corners may be copies, at the same places.
bool isOriginal(const SurfaceMesh& uncut, const SurfaceMesh& cut, int t) {
    if (t >= uncut.triangleSlots()) {
        return false;
    }
    for (int i = 0; i < 3; ++i) {
        if (cut.restPosition(cut.triangle(t)[i]) != uncut.restPosition(uncut.triangle(t)[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<CornerUvs> carryUvs(const SurfaceMesh& uncut, const std::vector<CornerUvs>& uvs,
                                const SurfaceMesh& cut) {
    if (uvs.empty()) {
        return {};
    }
    assert(static_cast<int>(uvs.size()) == uncut.triangleSlots());
    UvLookup lookup(uncut, uvs);
    std::vector<CornerUvs> out(cut.triangleSlots(), noUvs());
    for (int t = 0; t < cut.triangleSlots(); ++t) {
        if (!cut.alive(t) || cut.kind(t) != SurfaceKind::skin) {
            continue;
        }
        out[t] = isOriginal(uncut, cut, t) ? uvs[t] : lookup.uvsOf(cut.triangle(t), cut);
    }
    return out;
}

}  // namespace kerf
