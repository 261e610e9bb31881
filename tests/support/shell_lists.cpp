#include "tests/support/shell_lists.h"

namespace kerf::test {

std::vector<EdgeConstraint> buildEdges(const SurfaceMesh& mesh, double thickness) {
    std::vector<EdgeConstraint> edges;
    forEachEdge(mesh, [&](int h) { edges.push_back(edgeConstraint(mesh, h, thickness)); });
    return edges;
}

std::vector<BendConstraint> buildBends(const SurfaceMesh& mesh, double thickness) {
    std::vector<BendConstraint> bends;
    forEachEdge(mesh, [&](int h) {
        if (const auto bend = bendConstraint(mesh, h, thickness)) {
            bends.push_back(*bend);
        }
    });
    return bends;
}

}  // namespace kerf::test
