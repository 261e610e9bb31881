#include "sim/repair/remesher.h"

#include <gtest/gtest.h>

#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/triangle_quality.h"
#include "sim/repair/soup_inspection.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

/// [degrees]
double leastAngle(const TriangleSoup& soup) {
    double least = 180;
    for (const Triangle& t : soup.triangles) {
        for (int i = 0; i < 3; ++i) {
            const Vec3 u = soup.positions[t[(i + 1) % 3]] - soup.positions[t[i]];
            const Vec3 v = soup.positions[t[(i + 2) % 3]] - soup.positions[t[i]];
            least =
                std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi);
        }
    }
    return least;
}

/// A box of long needles.
TriangleSoup needles() {
    TriangleSoup soup = test::boxSoup(Vec3(1, 1, 1), 12);
    for (Vec3& p : soup.positions) {
        p.x() *= 0.05;
    }
    return soup;
}

TEST(Remesher, MakesEvenTrianglesAndKeepsTheVolume) {
    for (TriangleSoup soup :
         {test::gradedSphereSoup(), test::bentTubeSoup(60, 16), test::torusSoup(90, 12)}) {
        const double volume = inspectTriangles(soup).volume;
        const double edge = figuresOf(soup).meanEdge();
        repair::remesh(soup, edge);
        const MeshReport report = inspectTriangles(soup);
        EXPECT_EQ(report.problem, "");
        EXPECT_NEAR(report.volume, volume, 0.01 * volume);
        EXPECT_GT(leastAngle(soup), 15);
        EXPECT_NEAR(figuresOf(soup).meanEdge(), edge, 0.25 * edge);
        EXPECT_EQ(checkClosedManifold(test::meshOf(soup)), "");
    }
}

TEST(Remesher, KeepsHardEdges) {
    TriangleSoup soup = needles();
    const Bounds before = inspectTriangles(soup).bounds;
    repair::remesh(soup, 0.05);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.problem, "");
    EXPECT_NEAR(report.volume, 0.05, 1e-6);
    EXPECT_NEAR((report.bounds.low - before.low).norm(), 0, 1e-12);
    EXPECT_NEAR((report.bounds.high - before.high).norm(), 0, 1e-12);
    EXPECT_GT(leastAngle(soup), 15);
}

TEST(Remesher, RefinesWhatIsCoarseAndKeepsItsFlatFaces) {
    TriangleSoup soup = test::boxSoup();
    const double edge = proposedEdge(figuresOf(soup), std::sqrt(3));
    repair::remesh(soup, edge);
    EXPECT_EQ(inspectTriangles(soup).problem, "");
    EXPECT_NEAR(inspectTriangles(soup).volume, 1, 1e-12);
    for (const Vec3& p : soup.positions) {
        ASSERT_NEAR(p.cwiseAbs().maxCoeff(), 0.5, 1e-12) << "beside the surface";
    }
    const TriangleFigures figures = figuresOf(soup);
    EXPECT_NEAR(figures.area, 6, 1e-12);
    EXPECT_LT(figures.longestEdge, 1.6 * edge);
    EXPECT_GT(figures.shortestEdge, 0.4 * edge);
    EXPECT_NEAR(figures.meanEdge(), edge, 0.2 * edge);
    EXPECT_GT(leastAngle(soup), 20);
    EXPECT_FALSE(isCoarse(figures, std::sqrt(3)));
}

}  // namespace
}  // namespace kerf
