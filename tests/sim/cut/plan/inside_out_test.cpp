#include "sim/cut/plan/curves/inside_out.h"

#include <gtest/gtest.h>

#include "sim/cut/plan/curves/intersections.h"
#include "sim/cut/plan/strip/swept_strip.h"
#include "tests/support/shapes.h"
#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

using test::bladeAt;

/// A blade that comes into a box from the air.
class InsideOutOfAStrip : public ::testing::Test {
  protected:
    InsideOutOfAStrip() {
        bench.begin(bladeAt(1, 0.1));
        PredicatePositions positions(in());
        strip = buildStrip(in(), positions);
        curves = intersect(in(), strip, positions);
        points = borderPoints(in(), strip, in().pieceOfVertex[0], curves, curves.segments);
    }
    StepInput in() { return bench.stepTo(bladeAt(0, 0.1)); }
    int inside(const std::vector<BorderPoint>& told) {
        return static_cast<int>(std::ranges::count(told, true, &BorderPoint::inside));
    }

    test::StepBench bench{test::box(), 0.25};
    Strip strip;
    CutCurves curves;
    std::vector<BorderPoint> points;
};

TEST_F(InsideOutOfAStrip, TheBorderEntersTheBodyOnceAndLeavesIt) {
    EXPECT_EQ(std::ranges::count(points, 1, &BorderPoint::event), 1);
    EXPECT_EQ(std::ranges::count(points, -1, &BorderPoint::event), 1);
    const auto told = tellInsideOut(in(), strip, points);
    EXPECT_EQ(inside(told), 1) << "the part of the blade between the two";
    const auto entry = std::ranges::find(told, true, &BorderPoint::inside);
    EXPECT_EQ(entry->event, 1);
    EXPECT_TRUE(strip.onNewRung(entry->edge));
}

TEST_F(InsideOutOfAStrip, WithoutCurvesAllLiesOutside) {
    for (BorderPoint& point : points) {
        point.event = 0;
    }
    EXPECT_EQ(inside(tellInsideOut(in(), strip, points)), 0);
}

TEST_F(InsideOutOfAStrip, EndsInAnOrderThatCannotBeAreSwappedWhereTheyLieClose) {
    const auto entry = std::ranges::find(points, 1, &BorderPoint::event);
    ASSERT_NE(entry + 1, points.end());
    entry->event = -1;
    (entry + 1)->event = 1;
    EXPECT_EQ(test::reasonOf([&] { tellInsideOut(in(), strip, points); }),
              "the blade's border enters the body twice");
    (entry + 1)->u = entry->u + 0.01;
    EXPECT_EQ(inside(tellInsideOut(in(), strip, points)), 1);
}

}  // namespace
}  // namespace kerf::cut
