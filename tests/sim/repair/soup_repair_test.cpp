#include "sim/repair/soup_repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "sim/mesh/invariants.h"
#include "sim/repair/soup_inspection.h"
#include "sim/repair/vertex_parting.h"
#include "tests/support/model_defects.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// As the reader of files does it, which refuses indices that are not there.
TriangleSoup welded(const TriangleSoup& soup) {
    return inspectTriangles(soup).outOfRangeIndices > 0 ? soup : weldExactly(soup);
}

void expectRepaired(TriangleSoup soup) {
    soup = welded(soup);
    ASSERT_FALSE(inspectTriangles(soup).cuttable);
    const double diagonal = inspectTriangles(soup).bounds.diagonal();
    EXPECT_THAT(repair::repairSoup(soup), Not(IsEmpty()));
    repair::moveApart(soup);
    roundToFloats(soup);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.problem, "");
    EXPECT_LE(report.bounds.diagonal(), 1.001 * diagonal);
    EXPECT_GT(report.volume, 0.3);
    if (report.cuttable) {
        EXPECT_EQ(checkClosedManifold(test::meshOf(soup)), "");
    }
}

TEST(Repair, MendsEachDefect) {
    for (const auto& [name, spoil] : test::modelDefects()) {
        SCOPED_TRACE(name);
        TriangleSoup soup = test::soundBall();
        spoil(soup);
        expectRepaired(soup);
    }
}

TEST(Repair, MendsDefectsInPairs) {
    for (const auto& [first, spoil] : test::modelDefects()) {
        for (const auto& [second, spoilMore] : test::modelDefects()) {
            SCOPED_TRACE(::testing::Message() << first << ", " << second);
            TriangleSoup soup = test::soundBall();
            spoil(soup);
            spoilMore(soup);
            if (!inspectTriangles(soup).cuttable) {
                expectRepaired(soup);
            }
        }
    }
}

TEST(Repair, LeavesWhatIsSound) {
    TriangleSoup soup = test::torusSoup();
    const TriangleSoup before = soup;
    EXPECT_THAT(repair::repairSoup(soup), IsEmpty());
    EXPECT_EQ(soup.positions, before.positions);
    EXPECT_EQ(soup.triangles, before.triangles);
}

TEST(Repair, SolidsThatTouchStayApart) {
    const TriangleSoup box = test::boxSoup();
    TriangleSoup touching = test::joined(box, box, Vec3(1, 0, 0));
    touching.triangles.push_back({0, 0, 1});
    EXPECT_EQ(repair::repairSoup(touching).size(), 1u);
    EXPECT_EQ(inspectTriangles(touching).problem, "");
    EXPECT_EQ(inspectTriangles(touching).pieces, 2);
    EXPECT_EQ(touching.triangles.size(), 2 * box.triangles.size());
}

TEST(Repair, SaysWhatItDid) {
    TriangleSoup soup = test::soundBall();
    soup.triangles.erase(soup.triangles.begin() + 5);
    soup.triangles.push_back(soup.triangles[60]);
    const std::vector<std::string> done = repair::repairSoup(soup);
    EXPECT_THAT(done, Contains("filled 1 hole"));
    EXPECT_THAT(done, Contains(HasSubstr("1 double")));
}

TEST(Repair, FillsHolesWithTrianglesLikeThoseAround) {
    TriangleSoup soup = test::icosphereSoup(4);
    std::erase_if(soup.triangles,
                  [&](const Triangle& t) { return soup.positions[t[0]].y() > 0.3; });
    const std::size_t before = soup.triangles.size();
    const double volume = inspectTriangles(test::icosphereSoup(4)).volume;
    repair::repairSoup(soup);
    EXPECT_GT(soup.triangles.size(), before + 150) << "not a fan of long triangles";
    EXPECT_NEAR(inspectTriangles(soup).volume, volume, 0.12 * volume);
    EXPECT_EQ(inspectTriangles(soup).problem, "");
}

TEST(Repair, WhateverComesIsMendedOrRefused) {
    int mended = 0;
    constexpr int kRuns = 150;
    for (unsigned seed = 0; seed < kRuns; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TriangleSoup soup = seed % 2 == 0 ? test::icosphereSoup(2) : test::torusSoup(16, 8);
        test::damage(soup, random, 12);
        soup = weldExactly(soup);
        repair::repairSoup(soup);
        const MeshReport report = inspectTriangles(soup);
        EXPECT_EQ(report.cuttable, report.problem.empty());
        if (report.cuttable) {
            EXPECT_EQ(checkClosedManifold(test::meshOf(soup)), "");
            ++mended;
        }
    }
    EXPECT_GT(mended, kRuns * 8 / 10);
}

TEST(Repair, SheetStaysAndIsRefused) {
    TriangleSoup sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    repair::repairSoup(sheet);
    EXPECT_FALSE(inspectTriangles(sheet).cuttable);
    EXPECT_THAT(inspectTriangles(sheet).problem, HasSubstr("give it thickness"));
}

}  // namespace
}  // namespace kerf
