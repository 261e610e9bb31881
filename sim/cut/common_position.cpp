#include "sim/cut/common_position.h"

#include <algorithm>
#include <vector>

namespace kerf::cut {

Vec3 commonPosition(const SurfaceMesh& mesh, int v, double distance) {
    const Vec3& own = mesh.position(v);
    const int group = mesh.mateGroup(v);
    if (group < 0) {
        return own;
    }
    const std::vector<int>& mates = mesh.matesOfGroup(group);
    // Rounding would move the mean of equal positions.
    if (std::ranges::all_of(mates, [&](int mate) { return mesh.position(mate) == own; })) {
        return own;
    }
    Vec3 mean = Vec3::Zero();
    for (const int mate : mates) {
        mean += mesh.position(mate);
    }
    mean /= static_cast<double>(mates.size());
    const bool meet = std::ranges::all_of(
        mates, [&](int mate) { return (mesh.position(mate) - mean).norm() <= distance; });
    return meet ? mean : own;
}

}  // namespace kerf::cut
