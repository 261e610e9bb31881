#include "sim/repair/crossings.h"

#include <gtest/gtest.h>

#include "tests/support/self_intersections.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

int crossingTriangles(const TriangleSoup& soup) {
    MeshReport report;
    repair::countCrossings(soup, report);
    return report.crossingTriangles;
}

TEST(Crossings, SoundShapesHaveNone) {
    EXPECT_EQ(crossingTriangles(test::icosphereSoup(3)), 0);
    EXPECT_EQ(crossingTriangles(test::torusSoup()), 0);
    EXPECT_EQ(crossingTriangles({}), 0);
}

TEST(Crossings, AreThoseThatEveryPairWouldShow) {
    const TriangleSoup both =
        test::joined(test::icosphereSoup(3), test::torusSoup(), Vec3(0.31, 0.12, 0.07));
    EXPECT_EQ(repair::findCrossings(both, 1'000'000), test::selfIntersections(test::meshOf(both)));
    EXPECT_GT(crossingTriangles(both), 50);
    EXPECT_EQ(repair::findCrossings(both, 7).size(), 7u);
}

TEST(Crossings, ShellsThatOnlyTouchDoNotCross) {
    EXPECT_EQ(crossingTriangles(test::joined(test::boxSoup(), test::boxSoup(), Vec3(1, 0, 0))), 0);
}

}  // namespace
}  // namespace kerf
