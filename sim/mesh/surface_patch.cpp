#include "sim/mesh/surface_patch.h"

#include <queue>

#include "sim/mesh/triangle.h"

namespace kerf {

namespace {

double squaredDistance(const Corners& corners, const Vec3& at) {
    const Vec3 shares = closestWeights(at, corners[0], corners[1], corners[2]);
    const Vec3 nearest = shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
    return (nearest - at).squaredNorm();
}

/// -1 where there is none.
int nearestTriangle(const SurfaceMesh& mesh, const Vec3& at) {
    int nearest = -1;
    double least = std::numeric_limits<double>::max();
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const double away = mesh.present(t) ? squaredDistance(cornersOf(mesh, t), at) : least;
        if (away < least) {
            least = away;
            nearest = t;
        }
    }
    return nearest;
}

/// Grows over the surface from a triangle, the nearest vertex first.
class PatchGrowth {
  public:
    PatchGrowth(const SurfaceMesh& mesh, const Vec3& at, int triangle)
        : mesh_(mesh), taken_(mesh.vertexCount()), way_(mesh.vertexCount(), kFar) {
        for (const int v : mesh.triangle(triangle)) {
            reach(v, (mesh.position(v) - at).norm());
            take(v);
        }
    }

    void growTo(double radius) {
        while (!next_.empty() && next_.top().first <= radius) {
            const auto [way, v] = next_.top();
            next_.pop();
            if (!taken_[v] && !take(v)) {
                return;
            }
            reachNeighbours(v, way);
        }
    }

    std::vector<int> vertices() const {
        std::vector<int> vertices;
        for (int v = 0; v < mesh_.vertexCount(); ++v) {
            if (taken_[v]) {
                vertices.push_back(v);
            }
        }
        return vertices;
    }

  private:
    using Reached = std::pair<double, int>;  ///< way [m], vertex
    static constexpr double kFar = std::numeric_limits<double>::max();

    void reach(int v, double way) {
        if (way < way_[v]) {
            way_[v] = way;
            next_.emplace(way, v);
        }
    }

    void reachNeighbours(int v, double way) {
        mesh_.forEachOutgoing(v, [&](int h) {
            const int twin = mesh_.twin(h);
            if (mesh_.present(SurfaceMesh::triangleOf(h)) ||
                mesh_.present(SurfaceMesh::triangleOf(twin))) {
                const int w = mesh_.target(h);
                reach(w, way + (mesh_.position(w) - mesh_.position(v)).norm());
            }
        });
    }

    /// False where it holds the other side of the cut already.
    bool take(int v) {
        const int group = mesh_.copyGroup(v);
        if (group >= 0 && std::ranges::any_of(mesh_.copiesOfGroup(group),
                                              [&](int copy) { return bool(taken_[copy]); })) {
            return false;
        }
        taken_[v] = true;
        return true;
    }

    const SurfaceMesh& mesh_;
    std::vector<bool> taken_;
    std::vector<double> way_;  ///< from the point, along edges [m]
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next_;
};

}  // namespace

std::vector<int> surfacePatch(const SurfaceMesh& mesh, const Vec3& at, double radius) {
    const int triangle = nearestTriangle(mesh, at);
    if (triangle < 0) {
        return {};
    }
    PatchGrowth growth(mesh, at, triangle);
    growth.growTo(radius);
    return growth.vertices();
}

}  // namespace kerf
