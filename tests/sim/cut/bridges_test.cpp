#include <gtest/gtest.h>

#include "sim/cut/plan/air_edges.h"

namespace kerf::cut {
namespace {

constexpr int kStroke = 1;
constexpr int kPlus = 0;   ///< triangle of its wall W+
constexpr int kMinus = 1;  ///< of W-
constexpr int kSkin = 2;

/// One triangle of each kind; leavesBridge asks for labels alone.
SurfaceMesh oneTriangleEach() {
    SurfaceMesh mesh;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
        mesh.addVertex(p, p, Vec3::Zero());
    }
    mesh.addTriangle({0, 1, 2}, SurfaceKind::wall, 2 * kStroke);
    mesh.addTriangle({0, 2, 1}, SurfaceKind::wall, 2 * kStroke + 1);
    mesh.addTriangle({0, 1, 2}, SurfaceKind::skin, -1);
    return mesh;
}

/// A new wall from the old rung at y = 0 on, in a loop of its own.
class Plan {
  public:
    /// The start in the material, curves in these triangles, and the new front, if there is one.
    Plan& loop(bool starts, const std::vector<int>& triangles, bool hasFront, int piece = 0) {
        const int first = sizeOf(plan_.curves.nodes);
        int last = node(0);
        if (starts) {
            last = edge(last, node(0), OutlineKind::free, piece);
        }
        for (const int t : triangles) {
            plan_.curves.segments.push_back({t, 0, last, sizeOf(plan_.curves.nodes)});
            last = edge(last, node(0.5), OutlineKind::cut, piece);
        }
        if (hasFront) {
            const int end = node(1);
            plan_.outline.front = {{1, last, true}, {0, end, false}};
            last = edge(last, end, OutlineKind::free, piece);
        }
        edge(last, first, OutlineKind::cut, piece);
        return *this;
    }

    bool leavesBridge() const { return cut::leavesBridge(oneTriangleEach(), kStroke, {0}, plan_); }

  private:
    int node(double y) {
        CutNode node;
        node.layout = {0, y};
        plan_.curves.nodes.push_back(node);
        return sizeOf(plan_.curves.nodes) - 1;
    }

    int edge(int from, int to, OutlineKind kind, int piece) {
        plan_.outline.edges.push_back({from, to, kind, piece});
        return to;
    }

    StepPlan plan_;
};

TEST(Bridges, WallsThatCrossTheOldOnesAllAlongLeaveNone) {
    EXPECT_FALSE(
        Plan().loop(true, {kSkin, kPlus}, false).loop(false, {kMinus}, true).leavesBridge());
}

TEST(Bridges, AroundTheEndOfTheOldWallsOneIsLeft) {
    EXPECT_TRUE(Plan().loop(true, {kPlus, kMinus}, true).leavesBridge());
    EXPECT_TRUE(Plan().loop(true, {kPlus, kMinus}, false).leavesBridge());
}

TEST(Bridges, WallsThatMissTheOldOnesLeaveOne) {
    EXPECT_TRUE(Plan().loop(true, {kSkin}, true).leavesBridge());
    EXPECT_TRUE(Plan().loop(true, {kSkin}, false).leavesBridge());
}

TEST(Bridges, AStartOnBothSidesOfTheOldWallsLeavesOne) {
    EXPECT_TRUE(Plan().loop(true, {kPlus}, false).loop(true, {kMinus}, false).leavesBridge());
    EXPECT_TRUE(Plan().loop(true, {kPlus}, false).loop(true, {kMinus}, true).leavesBridge());
}

TEST(Bridges, PiecesWithoutTheFrontDoNotMatter) {
    EXPECT_FALSE(Plan().loop(true, {kPlus}, false).loop(true, {kSkin}, true, 1).leavesBridge());
}

TEST(Bridges, ThePiecesOfARungAreThoseOfItsFrontEdges) {
    const std::vector<int> pieceOfVertex{4, 4, 7, 9};
    const std::vector<RungNode> rung{{Vec3::Zero(), 0.0, -1, false}, {Vec3::Zero(), 0.2, 0, true},
                                     {Vec3::Zero(), 0.4, 1, false},  {Vec3::Zero(), 0.5, 2, true},
                                     {Vec3::Zero(), 0.6, 2, false},  {Vec3::Zero(), 0.8, 3, false}};
    EXPECT_EQ(piecesOfFront(rung, pieceOfVertex), (std::set<int>{4, 7}));
}

}  // namespace
}  // namespace kerf::cut
