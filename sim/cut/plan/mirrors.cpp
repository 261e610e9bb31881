#include "sim/cut/plan/mirrors.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "sim/cut/wall_copies.h"

namespace kerf::cut {

namespace {

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
            const int mirror = mirrorOf(mesh_, t);
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

    bool dividesAlike() {
        nodes_ = pointKeys(mesh_, plan_.curves);
        Balance balance;
        const Subdivision& subdivision = plan_.subdivision;
        for (int i = 0; i < sizeOf(subdivision.triangles); ++i) {
            if (std::ranges::binary_search(mirrored_, subdivision.parents[i])) {
                add(subdivision.triangles[i], balance);
            }
        }
        return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
    }

    void add(const NewTriangle& t, Balance& balance) const {
        WallKey key{t.wallLabel / 2,
                    {keyOf(t.corners[0]), keyOf(t.corners[1]), keyOf(t.corners[2])}};
        std::ranges::sort(key.second);
        balance[key] += t.wallLabel % 2 == 0 ? 1 : -1;
    }

    PointKey keyOf(int corner) const {
        return corner < mesh_.vertexCount() ? PointKey{mesh_.firstCopy(corner), -1, -1, -1}
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
