#include "sim/cut/plan/edge_repair.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace kerf::cut {
namespace {

constexpr int kManyNumbers = 4;  // subdivisions: neighbours whose numbers share bits

// Two neighbours of a vertex become one: both of its edges have the same ends then.
void joinTwoNeighbours(SurfaceMesh& mesh, int v) {
    std::vector<int> neighbours;
    mesh.forEachOutgoing(v, [&](int h) { neighbours.push_back(mesh.target(h)); });
    const int kept = neighbours[0];
    const int gone = neighbours[2];
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.origin(h) == gone) {
            mesh.setCorner(h / 3, h % 3, kept);
        }
    }
}

Umbrellas umbrellasOf(const SurfaceMesh& mesh) {
    Umbrellas all;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.forEachOutgoing(v, [&](int h) { all.spokes.push_back(h); });
        all.ends.push_back(static_cast<int>(all.spokes.size()));
    }
    return all;
}

TEST(CutEdgeRepair, FindsTwoEdgesWithTheSameEnds) {
    const SurfaceMesh whole = test::icosphere(kManyNumbers);
    const Umbrellas umbrellas = umbrellasOf(whole);
    EXPECT_FALSE(hasDuplicateEdges(whole, umbrellas));
    for (int v = 0; v < whole.vertexCount(); v += 97) {
        SurfaceMesh mesh = whole;
        joinTwoNeighbours(mesh, v);
        EXPECT_TRUE(hasDuplicateEdges(mesh, umbrellas)) << "vertex " << v;
        EXPECT_FALSE(hasDuplicateEdges(mesh, {})) << "vertex " << v;
    }
}

}  // namespace
}  // namespace kerf::cut
