#include "sim/cut/plan/mirrors.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace kerf::cut {

namespace {

/// The key that copies have in common. A vertex has its first copy; a node has the first copies of
/// its edge's or face's corners, and the strip's triangle or edge that meets it there.
using PointKey = std::array<int, 4>;
constexpr int kNothing = -1;

/// The stroke and the corners of a wall triangle.
using WallKey = std::pair<int, std::array<PointKey, 3>>;
/// By how many the triangles of W+ outnumber those of W-.
using Balance = std::map<WallKey, int>;

class MirrorCheck {
  public:
    MirrorCheck(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance)
        : mesh_(mesh), plan_(plan), closeDistance_(closeDistance) {}

    bool holds() {
        for (const int t : plan_.subdivision.replaced) {
            if (!isClosedWall(t)) {
                continue;
            }
            const int mirror = mirrorOf(t);
            if (mirror < 0) {
                continue;
            }
            if (!std::ranges::binary_search(plan_.subdivision.replaced, mirror)) {
                return false;
            }
            mirrored_.push_back(t);
        }
        return mirrored_.empty() || dividesAlike();
    }

  private:
    bool isClosedWall(int t) const {
        return mesh_.kind(t) == SurfaceKind::wall &&
               std::ranges::all_of(mesh_.triangle(t), [&](int v) { return isClosed(v); });
    }

    bool isClosed(int v) const {
        const int group = mesh_.copyGroup(v);
        if (group < 0) {
            return true;
        }
        const std::vector<int>& copies = mesh_.copiesOfGroup(group);
        const Vec3& first = mesh_.position(copies.front());
        return std::ranges::all_of(copies, [&](int copy) {
            return (mesh_.position(copy) - first).norm() <= closeDistance_;
        });
    }

    /// The wall triangle between copies of the same vertices on the other side, -1 for none.
    int mirrorOf(int t) const {
        const Triangle points = pointsOf(t);
        const int corner = mesh_.triangle(t)[0];
        int found = -1;
        const auto lookAround = [&](int v) {
            mesh_.forEachOutgoing(v, [&](int h) {
                if (mesh_.wallLabel(h / 3) == (mesh_.wallLabel(t) ^ 1) &&
                    pointsOf(h / 3) == points) {
                    found = h / 3;
                }
            });
        };
        if (mesh_.copyGroup(corner) < 0) {
            lookAround(corner);
        } else {
            std::ranges::for_each(mesh_.copiesOfGroup(mesh_.copyGroup(corner)), lookAround);
        }
        return found;
    }

    /// Ascending.
    Triangle pointsOf(int t) const {
        Triangle points = mesh_.triangle(t);
        for (int& point : points) {
            point = mesh_.firstCopy(point);
        }
        std::ranges::sort(points);
        return points;
    }

    bool dividesAlike() {
        nameNodes();
        Balance balance;
        const Subdivision& subdivision = plan_.subdivision;
        for (int i = 0; i < sizeOf(subdivision.triangles); ++i) {
            if (std::ranges::binary_search(mirrored_, subdivision.parents[i])) {
                add(subdivision.triangles[i], balance);
            }
        }
        return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
    }

    void nameNodes() {
        const CutCurves& curves = plan_.curves;
        nodes_.assign(curves.nodes.size(), {kNothing, kNothing, kNothing, kNothing});
        for (const auto& [edge, hits] : curves.onEdge) {
            const Edge points = edgeOf(mesh_.firstCopy(edge.first), mesh_.firstCopy(edge.second));
            for (const EdgeHit& hit : hits) {
                nodes_[hit.node] = {points.first, points.second, kNothing, hit.stripTriangle};
            }
        }
        for (const auto& [place, node] : curves.onFace) {
            const Triangle points = pointsOf(place.second);
            nodes_[node] = {points[0], points[1], points[2], place.first};
        }
    }

    void add(const NewTriangle& t, Balance& balance) const {
        WallKey key{t.wallLabel / 2,
                    {keyOf(t.corners[0]), keyOf(t.corners[1]), keyOf(t.corners[2])}};
        std::ranges::sort(key.second);
        balance[key] += t.wallLabel % 2 == 0 ? 1 : -1;
    }

    PointKey keyOf(int corner) const {
        return corner < mesh_.vertexCount()
                   ? PointKey{mesh_.firstCopy(corner), kNothing, kNothing, kNothing}
                   : nodes_[corner - mesh_.vertexCount()];
    }

    const SurfaceMesh& mesh_;
    const StepPlan& plan_;
    double closeDistance_;
    std::vector<int> mirrored_;  ///< closed walls of both sides that the step replaces, ascending
    std::vector<PointKey> nodes_;
};

}  // namespace

bool keepsMirrors(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance) {
    return MirrorCheck(mesh, plan, closeDistance).holds();
}

}  // namespace kerf::cut
