#include "sim/cut/common_position.h"

#include <algorithm>
#include <vector>

namespace kerf::cut {

Vec3 commonPosition(const SurfaceMesh& mesh, int v, double distance) {
    const Vec3& own = mesh.position(v);
    const int group = mesh.copyGroup(v);
    if (group < 0) {
        return own;
    }
    const std::vector<int>& copies = mesh.copiesOfGroup(group);
    // Rounding would move the mean of equal positions.
    if (std::ranges::all_of(copies, [&](int copy) { return mesh.position(copy) == own; })) {
        return own;
    }
    Vec3 mean = Vec3::Zero();
    for (const int copy : copies) {
        mean += mesh.position(copy);
    }
    mean /= static_cast<double>(copies.size());
    const bool meet = std::ranges::all_of(
        copies, [&](int copy) { return (mesh.position(copy) - mean).norm() <= distance; });
    return meet ? mean : own;
}

}  // namespace kerf::cut
