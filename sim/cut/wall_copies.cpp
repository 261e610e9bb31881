#include "sim/cut/wall_copies.h"

#include <algorithm>

namespace kerf::cut {

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
