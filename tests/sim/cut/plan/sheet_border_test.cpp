#include "sim/cut/plan/wall/sheet_border.h"

#include <gtest/gtest.h>

#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

/// A sheet with corners in the layout plane, counter-clockwise.
struct Drawn {
    explicit Drawn(const std::vector<Vec2>& corners) {
        for (const Vec2& p : corners) {
            nodes.emplace_back().layout = p;
        }
        for (int i = 0; i < sizeOf(nodes); ++i) {
            sheet.outer.push_back({i, (i + 1) % sizeOf(nodes), OutlineKind::cut, 0});
        }
    }
    double areaOf(const std::vector<Triangle>& triangles) const {
        double area = 0;
        for (const Triangle& t : triangles) {
            area += 0.5 * test::doubleLayoutArea(nodes, t);
        }
        return area;
    }
    std::vector<CutNode> nodes;
    Sheet2d sheet;
};

TEST(SheetBorder, TheInsideIsTriangulatedAndNothingElse) {
    const Drawn drawn({{0, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}});
    const BorderedSheet sheet(drawn.sheet, drawn.nodes, 5, 1);
    EXPECT_EQ(sheet.triangles().size(), 3U);
    EXPECT_NEAR(drawn.areaOf(sheet.triangles()), 3, 1e-12);
    EXPECT_EQ(sheet.bounds().high, Vec2(2, 2));
}

TEST(SheetBorder, AnInnerNodeGetsTheNumberGiven) {
    const Drawn drawn({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    BorderedSheet sheet(drawn.sheet, drawn.nodes, 40, 1);
    const Vec2 middle(0.9, 1.1);
    sheet.addInner(middle, Vec3(1, 2, 3), sheet.plane().locate(middle));
    ASSERT_EQ(sheet.inner().size(), 1U);
    EXPECT_EQ(sheet.inner().front().position, Vec3(1, 2, 3));
    const std::vector<Triangle> triangles = sheet.triangles();
    EXPECT_EQ(triangles.size(), 4U);
    for (const Triangle& t : triangles) {
        EXPECT_EQ(std::ranges::count(t, 40), 1);
    }
}

// Two corners at one place but for rounding: each triangle there takes the one whose edges bound
// it.
TEST(SheetBorder, NodesAtOnePlaceKeepTheirOwnTriangles) {
    const Drawn drawn({{1, 1}, {0, 2}, {0, 0}, {1 + 1e-14, 1}, {2, 0}, {2, 2}});
    const BorderedSheet sheet(drawn.sheet, drawn.nodes, 6, 1);
    const std::vector<Triangle> triangles = sheet.triangles();
    ASSERT_EQ(triangles.size(), 2U);
    for (const Triangle& t : triangles) {
        EXPECT_EQ(std::ranges::count(t, 0) + std::ranges::count(t, 3), 1);
    }
    EXPECT_NE(std::ranges::count(triangles[0], 0), std::ranges::count(triangles[1], 0));
}

TEST(SheetBorder, ABorderThatCrossesItselfIsRefused) {
    const Drawn drawn({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    EXPECT_EQ(test::reasonOf([&] { BorderedSheet(drawn.sheet, drawn.nodes, 4, 1); }),
              "the border of the wall crosses itself");
}

}  // namespace
}  // namespace kerf::cut
