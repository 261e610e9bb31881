#include "sim/cut/wall_copies.h"

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

std::vector<int> livingCopies(const SurfaceMesh& mesh, int vertex) {
    if (mesh.copyGroup(vertex) < 0) {
        return {vertex};
    }
    std::vector<int> living = mesh.copiesOfGroup(mesh.copyGroup(vertex));
    std::erase_if(living, [&](int copy) { return mesh.outgoing(copy) < 0; });
    return living;
}

Triangle pointsOf(const SurfaceMesh& mesh, int t) {
    Triangle points = mesh.triangle(t);
    for (int& point : points) {
        point = mesh.firstCopy(point);
    }
    std::ranges::sort(points);
    return points;
}

int mirrorOf(const SurfaceMesh& mesh, int t) {
    const Triangle points = pointsOf(mesh, t);
    int found = -1;
    for (const int copy : livingCopies(mesh, mesh.triangle(t)[0])) {
        mesh.forEachOutgoing(copy, [&](int h) {
            if (mesh.wallLabel(h / 3) == (mesh.wallLabel(t) ^ 1) &&
                pointsOf(mesh, h / 3) == points) {
                found = h / 3;
            }
        });
    }
    return found;
}

}  // namespace kerf::cut
