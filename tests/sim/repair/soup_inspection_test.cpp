#include "sim/repair/soup_inspection.h"

namespace kerf {
namespace {

/// Each triangle with corners of its own, as STL files give them.
constexpr unsigned kBoxSeed = 20261126;

TriangleSoup exploded(const TriangleSoup& soup) {
    TriangleSoup loose;
    for (const auto& [a, b, c] : soup.triangles) {
        const int first = static_cast<int>(loose.positions.size());
        for (const int v : {a, b, c}) {
            loose.positions.push_back(soup.positions[v]);
        }
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    return loose;
}

void turn(Triangle& t) {
    std::swap(t[1], t[2]);
}

TEST(Weld, JoinsLooseTriangles) {
    const TriangleSoup welded = weldExactly(exploded(icosphereSoup(2)));
    EXPECT_EQ(welded.positions.size(), 162u);
    EXPECT_TRUE(inspectTriangles(welded).cuttable);
}

TEST(Weld, KeepsTheOrderOfFirstUseAndDropsTheRest) {
    const TriangleSoup welded = weldExactly(
        {{{9, 9, 9}, {2, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{2, 1, 4}, {3, 2, 4}}});
    ASSERT_EQ(welded.positions.size(), 3u);
    EXPECT_EQ(welded.positions[0], Vec3(1, 0, 0));
    EXPECT_EQ(welded.positions[1], Vec3(2, 0, 0));
    EXPECT_EQ(welded.triangles[1], (Triangle{1, 0, 2}));
}

TEST(Weld, NegativeZeroEqualsZeroAndTheNextNumberDoesNot) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const TriangleSoup welded =
        weldExactly({{{0.0, 1, 0}, {-0.0, 1, 0}, {tiny, 1, 0}}, {{0, 1, 2}}});
    EXPECT_EQ(welded.positions.size(), 2u);
}

TEST(Inspect, SoundShape) {
    const MeshReport report = inspectTriangles(boxSoup(Vec3(1, 2, 3)));
    EXPECT_TRUE(report.cuttable);
    EXPECT_EQ(report.problem, "");
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.vertices, 8);
    EXPECT_EQ(report.triangles, 12);
    EXPECT_EQ(report.pieces, 1);
    EXPECT_NEAR(report.volume, 6, 1e-12);
    EXPECT_LT((report.bounds.high - Vec3(0.5, 1, 1.5)).norm(), 1e-12);
}

TEST(Inspect, WhatIsCuttableMakesASoundMesh) {
    for (const TriangleSoup& soup : {torusSoup(), bentTubeSoup(), cubeSphereSoup(8)}) {
        ASSERT_TRUE(inspectTriangles(soup).cuttable) << inspectTriangles(soup).problem;
        EXPECT_EQ(checkClosedManifold(meshOf(soup)), "");
    }
}

TEST(Inspect, Nothing) {
    EXPECT_THAT(inspectTriangles({}).problem, StartsWith("no triangles"));
}

TEST(Inspect, OpenEdgesAreCounted) {
    TriangleSoup soup = icosphereSoup(1);
    soup.triangles.pop_back();
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.openEdges, 3);
    EXPECT_FALSE(report.closed || report.cuttable);
    EXPECT_TRUE(report.manifold);
    EXPECT_EQ(report.problem,
              "3 open edges: the surface is not closed, so cut faces can't be capped; fill the "
              "holes in a modelling tool");
}

TEST(Inspect, EdgeWithThreeTriangles) {
    TriangleSoup soup = boxSoup();
    const auto [a, b, c] = soup.triangles[0];
    soup.positions.push_back(Vec3(0, 0, 5));
    soup.triangles.push_back({a, b, 8});
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.nonManifoldEdges, 1);
    EXPECT_EQ(report.openEdges, 2);
    EXPECT_FALSE(report.manifold);
    EXPECT_THAT(report.problem, HasSubstr("2 open edges, 1 edge with more than two triangles: "));
}

TEST(Inspect, DuplicateTriangle) {
    TriangleSoup soup = boxSoup();
    soup.triangles.push_back(soup.triangles[0]);
    EXPECT_EQ(inspectTriangles(soup).nonManifoldEdges, 3);
}

TEST(Inspect, PiecesThatTouchInAPoint) {
    const TriangleSoup soup = weldExactly(joined(boxSoup(), boxSoup(), Vec3::Ones()));
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.nonManifoldVertices, 1);
    EXPECT_TRUE(report.closed);
    EXPECT_FALSE(report.manifold);
    EXPECT_THAT(report.problem, StartsWith("1 vertex where the surface touches itself: "));
}

TEST(Inspect, OneTriangleTurned) {
    TriangleSoup soup = icosphereSoup(1);
    turn(soup.triangles[5]);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.misorientedEdges, 3);
    EXPECT_TRUE(report.closed && report.manifold);
    EXPECT_FALSE(report.oriented);
    EXPECT_THAT(report.problem, HasSubstr("face opposite ways"));
}

TEST(Inspect, TriangleWithARepeatedCornerLeavesTheTopologyAlone) {
    TriangleSoup soup = boxSoup();
    soup.triangles.push_back({0, 0, 1});
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.degenerateTriangles, 1);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_THAT(report.problem, StartsWith("1 triangle without area: "));
}

TEST(Inspect, TriangleWithoutArea) {
    // A needle across the middle of one edge of a box face.
    TriangleSoup soup = boxSoup();
    const auto [a, b, c] = soup.triangles[0];
    soup.positions.push_back(0.5 * (soup.positions[a] + soup.positions[b]));
    soup.triangles[0] = {a, 8, c};
    soup.triangles.push_back({8, b, c});
    soup.triangles.push_back({a, b, 8});
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.closed && report.manifold && report.oriented);
    EXPECT_EQ(report.degenerateTriangles, 1);
    EXPECT_FALSE(report.cuttable);
}

// A hole says nothing of how the triangles face.
TEST(Inspect, AMeshWithAHoleIsOrientedWhereItsTrianglesAgree) {
    TriangleSoup soup = boxSoup();
    soup.triangles.pop_back();
    EXPECT_FALSE(inspectTriangles(soup).closed);
    EXPECT_TRUE(inspectTriangles(soup).oriented);
    std::swap(soup.triangles[0][0], soup.triangles[0][1]);
    EXPECT_FALSE(inspectTriangles(soup).oriented);
}

TEST(Inspect, NotANumberAndOutOfRange) {
    TriangleSoup soup = icosphereSoup(0);
    soup.positions[2].y() = std::numeric_limits<double>::quiet_NaN();
    soup.triangles[3][1] = 12;
    soup.triangles[4][2] = -1;
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.nonFiniteVertices, 1);
    EXPECT_EQ(report.outOfRangeIndices, 2);
    EXPECT_FALSE(report.closed || report.manifold || report.oriented || report.cuttable);
    EXPECT_THAT(report.problem, HasSubstr("not a finite number"));
}

TEST(Inspect, FlatPiece) {
    const TriangleSoup pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    const MeshReport report = inspectTriangles(pillow);
    EXPECT_EQ(report.flatPieces, 1);
    EXPECT_THAT(report.problem, StartsWith("1 piece that encloses no volume: "));
}

TEST(TurnOutward, WholeModelInsideOut) {
    TriangleSoup soup = torusSoup();
    for (Triangle& t : soup.triangles) {
        turn(t);
    }
    EXPECT_THAT(inspectTriangles(soup).problem, StartsWith("1 piece that is inside out: "));
    EXPECT_EQ(turnOutward(soup), 1);
    EXPECT_TRUE(inspectTriangles(soup).cuttable);
}

TEST(TurnOutward, OnePieceOfTwo) {
    const TriangleSoup ball = icosphereSoup(1);
    TriangleSoup both = joined(boxSoup(Vec3(2, 2, 2)), ball, Vec3(3, 0, 0));
    for (std::size_t t = 12; t < both.triangles.size(); ++t) {
        turn(both.triangles[t]);
    }
    EXPECT_EQ(inspectTriangles(both).insideOutPieces, 1);
    EXPECT_EQ(turnOutward(both), 1);
    EXPECT_TRUE(inspectTriangles(both).cuttable);
    EXPECT_EQ(turnOutward(both), 0);
}

TEST(TurnOutward, CavityStays) {
    TriangleSoup hollow = joined(boxSoup(Vec3(2, 2, 2)), icosphereSoup(1), Vec3::Zero());
    for (std::size_t t = 12; t < hollow.triangles.size(); ++t) {
        turn(hollow.triangles[t]);
    }
    EXPECT_EQ(inspectTriangles(hollow).cavities, 1);
    EXPECT_EQ(inspectTriangles(hollow).problem, "");
    EXPECT_EQ(inspectTriangles(hollow).pieces, 1);
    EXPECT_TRUE(inspectTriangles(hollow).cuttable);
    EXPECT_EQ(turnOutward(hollow), 0);

    for (Triangle& t : hollow.triangles) {
        turn(t);
    }
    EXPECT_EQ(turnOutward(hollow), 2);
    EXPECT_EQ(inspectTriangles(hollow).cavities, 1);
}

TEST(TurnOutward, ShellInsideAnotherBecomesACavityAndOneInsideThatMaterial) {
    TriangleSoup nested = joined(boxSoup(Vec3(2, 2, 2)), icosphereSoup(1), Vec3::Zero());
    nested = joined(nested, icosphereSoup(1, 0.2), Vec3(0.1, 0, 0));
    nested = joined(nested, icosphereSoup(1, 0.1), Vec3(0.1, 0, 0));
    const MeshReport before = inspectTriangles(nested);
    EXPECT_EQ(before.outwardCavities, 2);
    EXPECT_FALSE(before.cuttable);
    EXPECT_EQ(turnOutward(nested), 2);
    const MeshReport after = inspectTriangles(nested);
    EXPECT_EQ(after.problem, "");
    EXPECT_EQ(after.cavities, 2);
    EXPECT_EQ(after.pieces, 2);
    EXPECT_NEAR(after.volume, 8 - 0.4 + 0.4 * 0.056, 0.1);
}

TEST(TurnOutward, ACoreThatFillsACavityStaysMaterial) {
    const TriangleSoup core = icosphereSoup(1);
    const TriangleSoup box = boxSoup(Vec3(2, 2, 2));
    const auto filled = [&](const TriangleSoup& first, const TriangleSoup& second) {
        return joined(joined(box, first, Vec3::Zero()), second, Vec3::Zero());
    };
    for (TriangleSoup soup : {filled(turned(core), core), filled(core, turned(core))}) {
        EXPECT_EQ(turnOutward(soup), 0);
        const MeshReport report = inspectTriangles(soup);
        EXPECT_EQ(report.problem, "");
        EXPECT_EQ(report.cavities, 1);
        EXPECT_EQ(report.pieces, 2);
        EXPECT_NEAR(report.volume, 8, 1e-12);
    }
}

TEST(TurnOutward, ShellsThatCrossStayAsTheyAre) {
    TriangleSoup both = joined(icosphereSoup(2), icosphereSoup(2, 0.3), Vec3(0.4, 0, 0));
    EXPECT_EQ(inspectTriangles(both).cavities, 0);
    EXPECT_EQ(turnOutward(both), 0);
    // One that looks out by a hundredth of the other's size, within its box.
    TriangleSoup eye =
        joined(icosphereSoup(4), icosphereSoup(2, 0.1), Vec3::Constant(0.415 / std::sqrt(3.0)));
    EXPECT_EQ(inspectTriangles(eye).cavities, 0);
    EXPECT_EQ(turnOutward(eye), 0);
}

/// A box between two corners.
TriangleSoup boxBetween(const Vec3& low, const Vec3& high) {
    TriangleSoup box = boxSoup(high - low);
    for (Vec3& p : box.positions) {
        p += (low + high) / 2;
    }
    return box;
}

TEST(TurnOutward, AShellOfWhichOnlyCornersLookOutStays) {
    // The middles of the cube's triangles lie in the ball.
    TriangleSoup both = joined(icosphereSoup(3, 1), boxSoup(Vec3::Constant(1.2)), Vec3::Zero());
    EXPECT_EQ(inspectTriangles(both).cavities, 0);
    EXPECT_EQ(turnOutward(both), 0);
}

TEST(TurnOutward, ShellsAroundThatCrossCountAsOne) {
    TriangleSoup soup = joined(boxBetween({0, 0, 0}, {2, 1, 1}),
                               boxBetween({1, 0.1, 0.1}, {3, 1.2, 1.2}), Vec3::Zero());
    soup = joined(soup, turned(boxBetween({1.4, 0.4, 0.4}, {1.6, 0.6, 0.6})), Vec3::Zero());
    const MeshReport report = inspectTriangles(soup);
    EXPECT_EQ(report.cavities, 1);
    EXPECT_TRUE(report.cuttable) << report.problem;
}

TriangleSoup all(const std::vector<TriangleSoup>& shells) {
    TriangleSoup soup;
    for (const TriangleSoup& shell : shells) {
        soup = joined(soup, shell, Vec3::Zero());
    }
    return soup;
}

TEST(TurnOutward, WhatStandsAtTheWallsOfACavityIsMaterial) {
    const TriangleSoup outer = boxBetween(Vec3::Zero(), Vec3::Constant(10));
    const TriangleSoup cavity = turned(boxBetween(Vec3::Ones(), Vec3::Constant(9)));
    const std::vector<TriangleSoup> inside{
        boxBetween({4, 4, 1}, {6, 6, 9}),       // a column from floor to ceiling
        boxBetween({7, 4, 4}, {9, 6, 6}),       // an island at a wall
        boxBetween({4, 4, 0.5}, {6, 6, 5}),     // a rib sunk into the floor
        boxBetween({4, 4, 0.5}, {6, 6, 9.5})};  // a pillar sunk into both
    for (const TriangleSoup& each : inside) {
        TriangleSoup soup = all({outer, cavity, each});
        EXPECT_EQ(inspectTriangles(soup).cavities, 1);
        EXPECT_EQ(turnOutward(soup), 0);
    }
}

TEST(TurnOutward, AnIslandInTheHollowOfTwoBodiesThatCrossIsMaterial) {
    const auto at = [](double x, const TriangleSoup& box) {
        return joined({}, box, Vec3(x, 0, 0));
    };
    const TriangleSoup outer = boxSoup(Vec3::Constant(10));
    const TriangleSoup cavity = turned(boxSoup(Vec3::Constant(8)));
    TriangleSoup soup = all({outer, cavity, at(4, outer), at(4, cavity), at(2, boxSoup())});
    EXPECT_EQ(inspectTriangles(soup).cavities, 2);
    EXPECT_EQ(turnOutward(soup), 0);
}

TEST(TurnOutward, CavitiesThatCrossAndThatTouchTheWallAreCavities) {
    const TriangleSoup outer = boxBetween(Vec3::Zero(), Vec3::Constant(10));
    TriangleSoup crossing = all({outer, turned(boxBetween({1, 1, 1}, {6, 6, 6})),
                                 turned(boxBetween({4, 4, 4}, {9, 9, 9}))});
    EXPECT_EQ(inspectTriangles(crossing).cavities, 2);
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool low : {true, false}) {
            Vec3 from = Vec3::Constant(4);
            Vec3 to = Vec3::Constant(5);
            (low ? from : to)[axis] = low ? 0 : 10;
            const TriangleSoup touching = all({outer, turned(boxBetween(from, to))});
            EXPECT_EQ(inspectTriangles(touching).cavities, 1);
            EXPECT_EQ(inspectTriangles(touching).insideOutPieces, 0);
        }
    }
}

/// Cavities behind a boss with the same four sides: rays along each axis lie in planes of both.
TEST(TurnOutward, CavitiesWithSidesInThePlanesOfOthersStay) {
    std::mt19937 random(kBoxSeed);
    std::uniform_int_distribution<int> tenths(5, 15);
    for (int run = 0; run < 60; ++run) {
        SCOPED_TRACE(testing::Message() << "seed " << kBoxSeed << ", run " << run);
        const auto tenth = [&] { return nearestFloat(0.1 * tenths(random)); };
        const Vec3 low(1, tenth(), tenth());
        const Vec3 high(2.5, 2 + tenth(), 2 + tenth());
        TriangleSoup soup = joined(boxBetween(Vec3::Zero(), Vec3::Constant(4)),
                                   turned(boxBetween(low, high)), Vec3::Zero());
        const int axis = run % 3;
        soup =
            joined(soup, boxBetween({5, low.y(), low.z()}, {6, high.y(), high.z()}), Vec3::Zero());
        for (Vec3& p : soup.positions) {
            p = Vec3(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]);
        }
        const MeshReport report = inspectTriangles(soup);
        EXPECT_EQ(report.cavities, 1);
        EXPECT_TRUE(report.cuttable) << report.problem;
        EXPECT_EQ(turnOutward(soup), 0);
    }
}

}  // namespace
}  // namespace kerf
