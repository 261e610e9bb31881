#include "sim/mesh/thickness.h"

#include "sim/base/math.h"
#include "sim/mesh/box_tree.h"
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

/// The triangles of one kind around a vertex, weighted by their angles there.
struct Fan {
    Vec3 normal = Vec3::Zero();
    Vec3 middle = Vec3::Zero();  ///< of their middles, times the weight
    double weight = 0;
};

/// Of each vertex over its skin and over its walls.
std::vector<Fan> fansOf(const SurfaceMesh& mesh) {
    std::vector<Fan> fans(std::size_t(2) * mesh.vertexCount());
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
            Fan& fan = fans[slotOf(mesh.triangle(t)[k], mesh.kind(t))];
            fan.normal += angle * unit;
            fan.middle += angle * (c[0] + c[1] + c[2]) / 3;
            fan.weight += angle;
        }
    }
    return fans;
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

    /// From beside a vertex, on its triangles of one kind, against a normal until the body is left;
    /// -1 where it never is.
    double lengthFrom(int vertex, SurfaceKind kind, const Vec3& start, const Vec3& normal) {
        const BoxRay ray(start, -normal.normalized());
        double best = kMissesBox;
        tree_.find(
            boundsOf_, [&](const Bounds& box) { return entryInto(box, ray, best) < kMissesBox; },
            [&](int t) {
                if (const auto at = exitThrough(cornersOf(mesh_, t), ray);
                    at && *at > nearest_ && *at < best &&
                    (mesh_.kind(t) != kind || !hasCorner(mesh_.triangle(t), vertex))) {
                    best = *at;
                }
            });
        return best < kMissesBox ? best : -1;
    }

  private:
    const SurfaceMesh& mesh_;
    BoxTree::BoundsOf boundsOf_ = [this](int t) { return boxOf(cornersOf(mesh_, t)); };
    BoxTree tree_;
    double nearest_ = 0;  ///< [m]
};

/// On the surface at a vertex, or beside it.
Vec3 startAt(const SurfaceMesh& mesh, int vertex, const Fan& fan, bool beside) {
    constexpr double kBeside = 0.25;  // of the way to the middle of its triangles
    const Vec3& at = mesh.position(vertex);
    return beside ? Vec3(at + kBeside * (fan.middle / fan.weight - at)) : at;
}

/// Gives a vertex without a value the mean of its neighbours, ring by ring.
void fillFromNeighbours(const SurfaceMesh& mesh, const std::vector<Fan>& fans,
                        std::vector<float>& values) {
    for (bool filled = true; filled;) {
        std::vector<std::pair<float, int>> sums(values.size());
        for (const int t : presentTriangles(mesh)) {
            for (int k = 0; k < 3; ++k) {
                const float value = values[slotOf(mesh.triangle(t)[k], mesh.kind(t))];
                for (int j = 1; j < 3 && value >= 0; ++j) {
                    auto& [sum, count] = sums[slotOf(mesh.triangle(t)[(k + j) % 3], mesh.kind(t))];
                    sum += value;
                    ++count;
                }
            }
        }
        filled = false;
        for (std::size_t slot = 0; slot < values.size(); ++slot) {
            const auto& [sum, count] = sums[slot];
            if (values[slot] < 0 && fans[slot].weight > 0 && count > 0) {
                values[slot] = sum / static_cast<float>(count);
                filled = true;
            }
        }
    }
}

}  // namespace

std::vector<float> surfaceThickness(const SurfaceMesh& mesh, const ShareDone& done) {
    const std::vector<Fan> fans = fansOf(mesh);
    std::vector<float> thickness(fans.size(), -1);
    InnerRays rays(mesh);
    const auto measure = [&](bool rims) {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (done && v % kVerticesATime == 0) {
                done(rims ? 1 : double(v) / mesh.vertexCount());
            }
            const std::size_t first = std::size_t(2) * v;
            const bool atRim = fans[first].weight > 0 && fans[first + 1].weight > 0;
            for (const std::size_t slot : {first, first + 1}) {
                if (atRim == rims && thickness[slot] < 0 && fans[slot].normal.squaredNorm() > 0) {
                    const SurfaceKind kind = slot == first ? SurfaceKind::skin : SurfaceKind::wall;
                    const Vec3 start = startAt(mesh, v, fans[slot], atRim);
                    thickness[slot] =
                        static_cast<float>(rays.lengthFrom(v, kind, start, fans[slot].normal));
                }
            }
        }
        fillFromNeighbours(mesh, fans, thickness);
    };
    // At a rim rays graze the other kind of surface: only what no neighbour reaches is measured.
    measure(false);
    measure(true);
    return thickness;
}

}  // namespace kerf
