#include "sim/mesh/thickness.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/mesh/box_tree.h"
#include "sim/mesh/ray_box.h"
#include "sim/mesh/triangle.h"

namespace kerf {
namespace {

constexpr double kOnEdge = 1e-9;   // of a triangle: no ray slips between two
constexpr double kNearest = 1e-7;  // of the body's diagonal: what is nearer is where it starts
constexpr int kVerticesATime = 512;

/// Where the ray leaves the body through a triangle, in lengths of its direction.
std::optional<double> exitThrough(const Corners& c, const BoxRay& ray) {
    const Vec3 normal = areaNormal(c);
    const double along = normal.dot(ray.direction);
    if (!(along > 0)) {
        return std::nullopt;
    }
    const double distance = normal.dot(c[0] - ray.origin) / along;
    const Vec3 at = ray.origin + distance * ray.direction;
    const double least = -kOnEdge * normal.squaredNorm();
    for (int e = 0; e < 3; ++e) {
        if (areaNormal(c[e], c[(e + 1) % 3], at).dot(normal) < least) {
            return std::nullopt;
        }
    }
    return distance;
}

std::size_t slotOf(int vertex, SurfaceKind kind) {
    return std::size_t(2) * vertex + (kind == SurfaceKind::wall ? 1 : 0);
}

/// Of each vertex over its skin and over its walls, weighted by corner angles; zero where it has
/// none of that kind.
std::vector<Vec3> vertexNormals(const SurfaceMesh& mesh) {
    std::vector<Vec3> normals(std::size_t(2) * mesh.vertexCount(), Vec3::Zero());
    for (const int t : livingTriangles(mesh)) {
        if (!mesh.present(t)) {
            continue;
        }
        const Corners c = cornersOf(mesh, t);
        const Vec3 unit = areaNormal(c).stableNormalized();
        for (int k = 0; k < 3; ++k) {
            const Vec3 u = c[(k + 1) % 3] - c[k];
            const Vec3 v = c[(k + 2) % 3] - c[k];
            const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
            normals[slotOf(mesh.triangle(t)[k], mesh.kind(t))] += angle * unit;
        }
    }
    return normals;
}

std::vector<int> presentTriangles(const SurfaceMesh& mesh) {
    std::vector<int> present = livingTriangles(mesh);
    std::erase_if(present, [&mesh](int t) { return mesh.absent(t); });
    return present;
}

bool hasCorner(const Triangle& triangle, int vertex) {
    return std::ranges::find(triangle, vertex) != triangle.end();
}

/// Sends rays through a body that stands still.
class InnerRays {
  public:
    explicit InnerRays(const SurfaceMesh& mesh)
        : mesh_(mesh), tree_(presentTriangles(mesh), boundsOf_) {
        nearest_ = kNearest * tree_.bounds().diagonal();
    }

    /// From a vertex against a normal until the body is left; -1 where it never is.
    double lengthFrom(int vertex, const Vec3& normal) {
        const BoxRay ray(mesh_.position(vertex), -normal.normalized());
        double best = kMissesBox;
        tree_.find(
            boundsOf_, [&](const Bounds& box) { return entryInto(box, ray, best) < kMissesBox; },
            [&](int t) {
                if (const auto at = exitThrough(cornersOf(mesh_, t), ray);
                    at && *at > nearest_ && *at < best && !hasCorner(mesh_.triangle(t), vertex)) {
                    best = *at;
                }
            });
        return best < kMissesBox ? best : -1;
    }

  private:
    const SurfaceMesh& mesh_;
    BoxTree::BoundsOf boundsOf_ = [this](int t) {
        const auto [a, b, c] = cornersOf(mesh_, t);
        return Bounds{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
    };
    BoxTree tree_;
    double nearest_ = 0;  ///< [m]
};

}  // namespace

std::vector<float> surfaceThickness(const SurfaceMesh& mesh, const ShareDone& done) {
    const std::vector<Vec3> normals = vertexNormals(mesh);
    std::vector<float> thickness(normals.size(), -1);
    InnerRays rays(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (done && v % kVerticesATime == 0) {
            done(double(v) / mesh.vertexCount());
        }
        for (const std::size_t slot : {std::size_t(2) * v, std::size_t(2) * v + 1}) {
            if (normals[slot].squaredNorm() > 0) {
                thickness[slot] = static_cast<float>(rays.lengthFrom(v, normals[slot]));
            }
        }
    }
    return thickness;
}

}  // namespace kerf
