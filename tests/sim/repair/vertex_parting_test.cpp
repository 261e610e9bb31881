#include "sim/repair/vertex_parting.h"

#include <gtest/gtest.h>

#include "sim/repair/crossings.h"
#include "sim/repair/soup_inspection.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

/// Still apart once a file of floats was written and read.
MeshReport asReadAgain(TriangleSoup soup) {
    repair::moveApart(soup);
    roundToFloats(soup);
    MeshReport report = inspectTriangles(soup);
    countCrossings(soup, report);
    return report;
}

TEST(MoveApart, LeavesWhatIsApart) {
    TriangleSoup ball = test::icosphereSoup(2);
    const std::vector<Vec3> before = ball.positions;
    EXPECT_EQ(repair::moveApart(ball), 0);
    EXPECT_EQ(ball.positions, before);
}

TEST(MoveApart, LeavesSolidsThatTouch) {
    TriangleSoup cubes = test::joined(test::boxSoup(), test::boxSoup(), Vec3(1, 0, 0));
    const std::vector<Vec3> before = cubes.positions;
    EXPECT_EQ(repair::moveApart(cubes), 0);
    EXPECT_EQ(cubes.positions, before);
}

TEST(MoveApart, CubesWithACornerAnEdgeOrAFaceInCommonBecomeTwo) {
    for (const Vec3& way : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 0)}) {
        const MeshReport report = asReadAgain(test::joined(test::boxSoup(), test::boxSoup(), way));
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(report.pieces, 2);
        EXPECT_EQ(report.crossingTriangles, 0);
        EXPECT_NEAR(report.volume, 2, 0.01);
    }
}

TEST(MoveApart, SolidsWithACornerAndItsSidesInCommonBecomeTwo) {
    const MeshReport report = asReadAgain(
        test::joined(test::boxSoup(Vec3::Constant(2)), test::boxSoup(), Vec3::Constant(0.5)));
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.vertices, 16);
}

TEST(MoveApart, ACavityThatTouchesTheWallStaysInside) {
    // A tetrahedron with one corner at a corner of the box around it.
    TriangleSoup box = test::boxSoup(Vec3::Constant(4));
    TriangleSoup cavity{{{-2, -2, -2}, {-1, -1, 0}, {0, -1, -1}, {-1, 0, -1}},
                        {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    const double own = inspectTriangles(cavity).volume;
    cavity = own > 0 ? test::turned(cavity) : cavity;
    const MeshReport report = asReadAgain(test::joined(box, cavity, Vec3::Zero()));
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.cavities, 1);
    EXPECT_EQ(report.crossingTriangles, 0);
    EXPECT_NEAR(report.volume, 64 - std::abs(own), 0.5);
}

TEST(MoveApart, CavitiesThatTouchStayTwo) {
    const TriangleSoup hollow = test::turned(test::boxSoup());
    TriangleSoup soup = test::joined(test::boxSoup(Vec3::Constant(8)), hollow, Vec3::Zero());
    soup = test::joined(soup, hollow, Vec3::Ones());
    const MeshReport report = asReadAgain(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.cavities, 2);
    EXPECT_EQ(report.crossingTriangles, 0);
}

}  // namespace
}  // namespace kerf
