#include "app/import/repair/soup_repair.h"

#include "app/import/piece_union.h"
#include "app/import/repair/double_triangles.h"
#include "app/import/repair/surface_meshing.h"
#include "app/import/repair/vertex_parting.h"
#include "sim/repair/soup_editing.h"
#include "tests/support/model_defects.h"

namespace kerf::app {
namespace {

/// As the reader of files does it, which refuses indices that are not there.
TriangleSoup welded(const TriangleSoup& soup) {
    return inspectTriangles(soup).outOfRangeIndices > 0 ? soup : weldExactly(soup);
}

void expectRepaired(TriangleSoup soup) {
    soup = welded(soup);
    ASSERT_FALSE(inspectTriangles(soup).cuttable);
    const double diagonal = inspectTriangles(soup).bounds.diagonal();
    EXPECT_THAT(repairSoup(soup), Not(IsEmpty()));
    ASSERT_EQ(inspectTriangles(soup).problem, "");
    uniteCrossingPieces(soup);  // as before a file is written: patches of two holes may coincide
    moveApart(soup);
    roundToFloats(soup);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.problem, "");
    EXPECT_LE(report.bounds.diagonal(), 1.001 * diagonal);
    EXPECT_GT(report.volume, 0.3);
    if (report.cuttable) {
        EXPECT_EQ(checkClosedManifold(meshOf(soup)), "");
    }
}

TEST(Repair, MendsEachDefect) {
    for (const auto& [name, spoil] : modelDefects()) {
        SCOPED_TRACE(name);
        TriangleSoup soup = soundBall();
        spoil(soup);
        expectRepaired(soup);
    }
}

TEST(Repair, MendsDefectsInPairs) {
    for (const auto& [first, spoil] : modelDefects()) {
        for (const auto& [second, spoilMore] : modelDefects()) {
            SCOPED_TRACE(::testing::Message() << first << ", " << second);
            TriangleSoup soup = soundBall();
            spoil(soup);
            spoilMore(soup);
            if (!inspectTriangles(soup).cuttable) {
                expectRepaired(soup);
            }
        }
    }
}

TEST(Repair, LeavesWhatIsSound) {
    TriangleSoup soup = torusSoup();
    const TriangleSoup before = soup;
    EXPECT_THAT(repairSoup(soup), IsEmpty());
    EXPECT_EQ(soup.positions, before.positions);
    EXPECT_EQ(soup.triangles, before.triangles);
}

TEST(Repair, SolidsThatTouchStayApart) {
    const TriangleSoup box = boxSoup();
    TriangleSoup touching = joined(box, box, Vec3(1, 0, 0));
    touching.triangles.push_back({0, 0, 1});
    EXPECT_EQ(repairSoup(touching).size(), 1u);
    EXPECT_EQ(inspectTriangles(touching).problem, "");
    EXPECT_EQ(inspectTriangles(touching).pieces, 2);
    EXPECT_EQ(touching.triangles.size(), 2 * box.triangles.size());
}

TEST(Repair, SaysWhatItDid) {
    TriangleSoup soup = soundBall();
    soup.triangles.erase(soup.triangles.begin() + 5);
    soup.triangles.push_back(soup.triangles[60]);
    const std::vector<std::string> done = repairSoup(soup);
    EXPECT_THAT(done, Contains("filled 1 hole"));
    EXPECT_THAT(done, Contains(HasSubstr("1 double")));
}

TEST(Repair, FillsHolesWithTrianglesLikeThoseAround) {
    TriangleSoup soup = icosphereSoup(4);
    std::erase_if(soup.triangles,
                  [&](const Triangle& t) { return soup.positions[t[0]].y() > 0.3; });
    const std::size_t before = soup.triangles.size();
    const double volume = inspectTriangles(icosphereSoup(4)).volume;
    repairSoup(soup);
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
        TriangleSoup soup = seed % 2 == 0 ? icosphereSoup(2) : torusSoup(16, 8);
        damage(soup, random, 12);
        soup = weldExactly(soup);
        repairSoup(soup);
        const MeshReport report = inspectTriangles(soup);
        EXPECT_EQ(report.cuttable, report.problem.empty());
        if (report.cuttable) {
            EXPECT_EQ(checkClosedManifold(meshOf(soup)), "");
            ++mended;
        }
    }
    EXPECT_GT(mended, kRuns * 8 / 10);
}

TEST(Repair, SheetStaysAndIsRefused) {
    TriangleSoup sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    repairSoup(sheet);
    EXPECT_FALSE(inspectTriangles(sheet).cuttable);
    EXPECT_THAT(inspectTriangles(sheet).problem, HasSubstr("give it thickness"));
}

Triangle backOf(const Triangle& t) {
    return {t[0], t[2], t[1]};
}

/// Doubles with the other side of all triangles whose corners lie above `z`.
TriangleSoup doubledAbove(TriangleSoup soup, double z) {
    const std::vector<Triangle> before = soup.triangles;
    for (const Triangle& t : before) {
        if (std::ranges::all_of(t, [&](int v) { return soup.positions[v].z() > z; })) {
            soup.triangles.push_back(backOf(t));
        }
    }
    return soup;
}

TEST(Doubles, OfADoubleSidedPartOneSideStays) {
    const double volume = inspectTriangles(icosphereSoup(3)).volume;
    for (const double z : {0.4, 0.25, 0.0, -0.3, -1.0}) {
        SCOPED_TRACE(z);
        TriangleSoup ball = doubledAbove(icosphereSoup(3), z);
        repairSoup(ball);
        const MeshReport report = inspectTriangles(ball);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(report.triangles, 1280);
        EXPECT_NEAR(report.volume, volume, 1e-12);
    }
}

/// A unit cube whose opposite faces have the same diagonal.
TriangleSoup cell() {
    TriangleSoup cube;
    for (int i = 0; i < 8; ++i) {
        cube.positions.emplace_back(i % 2, i / 2 % 2, i / 4);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3;
        const int v = 1 << (axis + 2) % 3;
        const int high = 1 << axis;
        cube.triangles.push_back({high, high + u, high + u + v});
        cube.triangles.push_back({high, high + u + v, high + v});
        cube.triangles.push_back({0, u + v, u});
        cube.triangles.push_back({0, v, u + v});
    }
    return cube;
}

/// Cubes side by side, `n` along each axis, with welded vertices.
TriangleSoup cubesInABlock(int n) {
    TriangleSoup all;
    for (int i = 0; i < n * n * n; ++i) {
        const Eigen::Vector3i place(i % n, i / n % n, i / (n * n));
        all = joined(all, cell(), place.cast<double>());
    }
    return weldExactly(all);
}

TEST(Doubles, OfWallsBetweenCubesNoneStays) {
    for (const int n : {2, 3, 4}) {
        TriangleSoup cubes = cubesInABlock(n);
        EXPECT_EQ(dropDoubles(cubes), 3 * (n - 1) * n * n * 4);
        const MeshReport report = inspectTriangles(cubes);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_NEAR(report.volume, n * n * n, 1e-12);
    }
}

TEST(Doubles, OfAFaceThatTwoSolidsHaveBothStay) {
    TriangleSoup longer = boxSoup(Vec3(2, 1, 1));
    TriangleSoup both = weldExactly(joined(longer, boxSoup(), Vec3(-0.5, 0, 0)));
    EXPECT_EQ(dropDoubles(both), 0);
    EXPECT_EQ(both.triangles.size(), 24u);
}

TEST(Doubles, OfAModelThatIsThereTwiceOneStays) {
    TriangleSoup ball = icosphereSoup(2);
    const std::vector<Triangle> before = ball.triangles;
    ball.triangles.insert(ball.triangles.end(), before.begin(), before.end());
    EXPECT_EQ(dropDoubles(ball), 320);
    EXPECT_EQ(ball.triangles, before);
}

TEST(Doubles, OfASolidThatIsThereOnceForEachSideAndHasANeighbourOneStays) {
    const TriangleSoup both = joined(cell(), turned(cell()), Vec3::Zero());
    TriangleSoup three = weldExactly(joined(both, cell(), Vec3(1, 0, 0)));
    repairSoup(three);
    const MeshReport report = inspectTriangles(three);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_NEAR(report.volume, 2, 0.01);
}

TEST(Doubles, OfAFlapNoneStays) {
    TriangleSoup box = boxSoup();
    const Triangle flap{0, 1, static_cast<int>(box.positions.size())};
    box.positions.emplace_back(2, 2, 2);
    box.triangles.push_back(flap);
    box.triangles.push_back(backOf(flap));
    EXPECT_EQ(dropDoubles(box), 2);
    EXPECT_TRUE(inspectTriangles(box).cuttable);
}

/// Still apart once a file of floats was written and read.
MeshReport asReadAgain(TriangleSoup soup) {
    moveApart(soup);
    roundToFloats(soup);
    MeshReport report = inspectTriangles(soup);
    countCrossings(soup, report);
    return report;
}

TEST(MoveApart, LeavesWhatIsApartAndSolidsThatTouch) {
    for (TriangleSoup soup : {icosphereSoup(2), joined(boxSoup(), boxSoup(), Vec3(1, 0, 0))}) {
        const std::vector<Vec3> before = soup.positions;
        EXPECT_EQ(moveApart(soup), 0);
        EXPECT_EQ(soup.positions, before);
    }
}

TEST(MoveApart, CubesWithACornerAnEdgeOrAFaceInCommonBecomeTwo) {
    for (const Vec3& way : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 0)}) {
        const MeshReport report = asReadAgain(joined(boxSoup(), boxSoup(), way));
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(report.pieces, 2);
        EXPECT_EQ(report.crossingTriangles, 0);
        EXPECT_NEAR(report.volume, 2, 0.01);
    }
}

TEST(MoveApart, SolidsWithACornerAndItsSidesInCommonBecomeTwo) {
    const MeshReport report =
        asReadAgain(joined(boxSoup(Vec3::Constant(2)), boxSoup(), Vec3::Constant(0.5)));
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.vertices, 16);
}

TEST(MoveApart, ACavityThatTouchesTheWallStaysInside) {
    // A tetrahedron with one corner at a corner of the box around it.
    TriangleSoup box = boxSoup(Vec3::Constant(4));
    TriangleSoup cavity{{{-2, -2, -2}, {-1, -1, 0}, {0, -1, -1}, {-1, 0, -1}},
                        {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    const double own = inspectTriangles(cavity).volume;
    cavity = own > 0 ? turned(cavity) : cavity;
    const MeshReport report = asReadAgain(joined(box, cavity, Vec3::Zero()));
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.cavities, 1);
    EXPECT_EQ(report.crossingTriangles, 0);
    EXPECT_NEAR(report.volume, 64 - std::abs(own), 0.5);
}

TEST(MoveApart, CavitiesThatTouchStayTwo) {
    const TriangleSoup hollow = turned(boxSoup());
    TriangleSoup soup = joined(boxSoup(Vec3::Constant(8)), hollow, Vec3::Zero());
    soup = joined(soup, hollow, Vec3::Ones());
    const MeshReport report = asReadAgain(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_EQ(report.cavities, 2);
    EXPECT_EQ(report.crossingTriangles, 0);
}

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
    TriangleSoup soup = boxSoup(Vec3(1, 1, 1), 12);
    for (Vec3& p : soup.positions) {
        p.x() *= 0.05;
    }
    return soup;
}

TEST(Remesher, MakesEvenTrianglesAndKeepsTheVolume) {
    for (TriangleSoup soup : {gradedSphereSoup(), bentTubeSoup(60, 16), torusSoup(90, 12)}) {
        const double volume = inspectTriangles(soup).volume;
        const double edge = figuresOf(soup).meanEdge();
        remesh(soup, edge);
        const MeshReport report = inspectTriangles(soup);
        EXPECT_EQ(report.problem, "");
        EXPECT_NEAR(report.volume, volume, 0.01 * volume);
        EXPECT_GT(leastAngle(soup), 15);
        EXPECT_NEAR(figuresOf(soup).meanEdge(), edge, 0.25 * edge);
        EXPECT_EQ(checkClosedManifold(meshOf(soup)), "");
    }
}

TEST(Remesher, KeepsHardEdges) {
    TriangleSoup soup = needles();
    const Bounds before = inspectTriangles(soup).bounds;
    remesh(soup, 0.05);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.problem, "");
    EXPECT_NEAR(report.volume, 0.05, 1e-6);
    EXPECT_NEAR((report.bounds.low - before.low).norm(), 0, 1e-12);
    EXPECT_NEAR((report.bounds.high - before.high).norm(), 0, 1e-12);
    EXPECT_GT(leastAngle(soup), 15);
}

TEST(Remesher, RefinesWhatIsCoarseAndKeepsItsFlatFaces) {
    TriangleSoup soup = boxSoup();
    const double edge = proposedEdge(figuresOf(soup), std::sqrt(3));
    remesh(soup, edge);
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

TEST(Remesher, MaterialsStayInTheirPlaces) {
    TriangleSoup soup = boxSoup(Vec3::Ones(), 4);
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        const Corners at = repair::cornersOf(soup, t);
        soup.skin.materials.push_back((at[0] + at[1] + at[2]).x() < 0 ? 3 : -1);
    }
    remesh(soup, 0.1);
    ASSERT_EQ(soup.skin.materials.size(), soup.triangles.size());
    for (int t = 0; t < static_cast<int>(soup.triangles.size()); ++t) {
        for (const Vec3& corner : repair::cornersOf(soup, t)) {
            EXPECT_TRUE(soup.skin.materials[t] == 3 ? corner.x() < 1e-12 : corner.x() > -1e-12);
        }
    }
}

}  // namespace
}  // namespace kerf::app
