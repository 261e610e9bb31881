#include "sim/repair/crossings.h"

#include "sim/repair/surface_contact.h"

namespace kerf::repair {
namespace {

int crossingTriangles(const TriangleSoup& soup) {
    MeshReport report;
    countCrossings(soup, report);
    return report.crossingTriangles;
}

// --- Solids of cubes, in places where edges, diagonals and faces meet ------------------------

using Cell = std::array<int, 3>;

Cell shifted(Cell cell, int axis, int by) {
    cell[axis] += by;
    return cell;
}

/// Cubes of two units, moved by whole units.
struct CubeSolid {
    std::set<Cell> cubes;
    Cell offset{};

    bool holds(const Cell& unit) const {
        Cell cube;
        for (int i = 0; i < 3; ++i) {
            cube[i] = (unit[i] - offset[i]) >> 1;
        }
        return cubes.contains(cube);
    }
};

/// Calls f with each unit cell that can be part of these solids.
template <class F>
void forEachUnit(F&& f) {
    constexpr int kReach = 12;
    for (int x = -kReach; x < kReach; ++x) {
        for (int y = -kReach; y < kReach; ++y) {
            for (int z = -kReach; z < kReach; ++z) {
                f(Cell{x, y, z});
            }
        }
    }
}

/// Whether one solid's surface lies partly in the other one, or has material on the same side where
/// both have a face: by looking at each unit square of it.
bool surfaceEnters(const CubeSolid& a, const CubeSolid& b) {
    bool same = false;
    bool within = false;
    bool beyond = false;
    forEachUnit([&](const Cell& unit) {
        if (!a.holds(unit)) {
            return;
        }
        for (int face = 0; face < 6; ++face) {
            const Cell next = shifted(unit, face / 2, face % 2 == 0 ? 1 : -1);
            if (!a.holds(next)) {
                const bool behind = b.holds(unit);
                const bool before = b.holds(next);
                same = same || (behind && !before);
                within = within || (behind && before);
                beyond = beyond || !behind;
            }
        }
    });
    return same || (within && beyond);
}

/// The two triangles of a square, divided by one of its diagonals.
void addSquare(const std::array<int, 4>& corners, bool other, TriangleSoup& soup) {
    const int k = other ? 1 : 0;
    const auto at = [&](int i) { return corners[(i + k) % 4]; };
    soup.triangles.push_back({at(0), at(1), at(2)});
    soup.triangles.push_back({at(0), at(2), at(3)});
}

/// The surface of a solid, with diagonals as they come.
TriangleSoup surfaceOf(const CubeSolid& solid, std::mt19937& random) {
    TriangleSoup soup;
    std::map<Cell, int> vertices;
    const auto vertex = [&](const Cell& corner) {
        const auto [found, isNew] = vertices.try_emplace(corner, vertices.size());
        if (isNew) {
            Cell place = solid.offset;
            for (int i = 0; i < 3; ++i) {
                place[i] += 2 * corner[i];
            }
            soup.positions.emplace_back(place[0], place[1], place[2]);
        }
        return found->second;
    };
    for (const Cell& cube : solid.cubes) {
        for (int face = 0; face < 6; ++face) {
            const int axis = face / 2;
            const bool upper = face % 2 == 0;
            if (solid.cubes.contains(shifted(cube, axis, upper ? 1 : -1))) {
                continue;
            }
            const Cell first = upper ? shifted(cube, axis, 1) : cube;
            const int u = (axis + (upper ? 1 : 2)) % 3;
            const int v = (axis + (upper ? 2 : 1)) % 3;
            addSquare({vertex(first), vertex(shifted(first, u, 1)),
                       vertex(shifted(shifted(first, u, 1), v, 1)), vertex(shifted(first, v, 1))},
                      random() % 2 == 0, soup);
        }
    }
    return soup;
}

/// Some cubes of 27 that are one piece with one surface which a cut can be made in.
CubeSolid randomSolid(std::mt19937& random) {
    while (true) {
        CubeSolid solid;
        const auto sparse = 2 + random() % 3;
        for (int i = 0; i < 27; ++i) {
            if (random() % sparse != 0) {
                solid.cubes.insert({i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1});
            }
        }
        const MeshReport report = inspectTriangles(surfaceOf(solid, random));
        if (report.cuttable && report.pieces == 1 && report.cavities == 0) {
            return solid;
        }
    }
}

/// No axis keeps its direction, and whole numbers stay whole.
TriangleSoup skewed(TriangleSoup soup) {
    Eigen::Matrix3d skew;
    skew << 3, 1, -1, -2, 4, 1, 1, -3, 5;
    for (Vec3& p : soup.positions) {
        p = skew * p;
    }
    return soup;
}

TEST(Crossings, OfRandomSolidsOfCubesAreWhereTheirCubesSaySo) {
    constexpr unsigned kSeed = 20261126;
    constexpr int kPairs = 400;
    std::mt19937 random(kSeed);
    int crossing = 0;
    for (int i = 0; i < kPairs; ++i) {
        const CubeSolid a = randomSolid(random);
        CubeSolid b = randomSolid(random);
        for (int& along : b.offset) {
            along = static_cast<int>(random() % 13) - 6;
        }
        const TriangleSoup both = joined(surfaceOf(a, random), surfaceOf(b, random), Vec3::Zero());
        const bool expected = surfaceEnters(a, b) || surfaceEnters(b, a);
        const std::string what = "pair " + std::to_string(i) + ", seed " + std::to_string(kSeed);
        ASSERT_EQ(!repair::findCrossings(both, 1).empty(), expected) << what;
        ASSERT_EQ(!repair::findCrossings(skewed(both), 1).empty(), expected) << what << ", skewed";
        crossing += expected ? 1 : 0;
    }
    EXPECT_GT(crossing, kPairs / 5);
    EXPECT_LT(crossing, kPairs * 4 / 5);
}

TEST(Crossings, OfBoxesThatMeetOnEdgesAndDiagonalsAloneAreFound) {
    const auto apartBy = [](const Vec3& offset) {
        return crossingTriangles(joined(boxSoup(), boxSoup(), offset));
    };
    EXPECT_GT(apartBy({0.5, 0.5, 0.5}), 0);
    EXPECT_GT(apartBy({0.5, 0, 0}), 0) << "four sides in common planes";
    EXPECT_GT(apartBy({0.5, 0.5, 0}), 0);
    EXPECT_EQ(apartBy({1, 0.5, 0.5}), 0) << "half a side touches";
    EXPECT_EQ(apartBy({1, 1, 0.5}), 0) << "half an edge touches";
    EXPECT_EQ(apartBy({1, 1, 1}), 0) << "a corner touches";
}

TEST(Crossings, OfAPegBehindAFaceThatOnlyTouchesAreFound) {
    // A plate on a block, with a foot that no hole was made for: nothing passes through the block's
    // top, since each edge in it has one face that lies on it and one that goes down.
    CubeSolid block;
    CubeSolid peg{.cubes = {{0, 0, -1}}, .offset = {1, 1, 0}};
    for (int x = -2; x < 3; ++x) {
        for (int y = -2; y < 3; ++y) {
            block.cubes.insert({x, y, -1});
            block.cubes.insert({x, y, -2});
            peg.cubes.insert({x, y, 0});
        }
    }
    std::mt19937 random(7);
    ASSERT_TRUE(surfaceEnters(peg, block));
    const TriangleSoup both =
        joined(surfaceOf(block, random), surfaceOf(peg, random), Vec3::Zero());
    EXPECT_GT(crossingTriangles(both), 0);
    EXPECT_GT(crossingTriangles(skewed(both)), 0);

    peg.cubes.erase({0, 0, -1});
    EXPECT_EQ(
        crossingTriangles(joined(surfaceOf(block, random), surfaceOf(peg, random), Vec3::Zero())),
        0)
        << "without its foot the plate lies on the block";
}

// --- Whole shapes ----------------------------------------------------------------------------

TEST(Crossings, SoundShapesHaveNone) {
    EXPECT_EQ(crossingTriangles(icosphereSoup(3)), 0);
    EXPECT_EQ(crossingTriangles(torusSoup()), 0);
    EXPECT_EQ(crossingTriangles({}), 0);
}

TEST(Crossings, AreThoseThatEveryPairWouldShow) {
    const TriangleSoup both = joined(icosphereSoup(3), torusSoup(), Vec3(0.31, 0.12, 0.07));
    EXPECT_EQ(repair::findCrossings(both, 1'000'000), selfIntersections(meshOf(both)));
    EXPECT_GT(crossingTriangles(both), 50);
    EXPECT_EQ(repair::findCrossings(both, 7).size(), 7u);
}

TEST(Crossings, ShellsThatOnlyTouchDoNotCross) {
    EXPECT_EQ(crossingTriangles(joined(boxSoup(), boxSoup(), Vec3(1, 0, 0))), 0);
}

const Corners kFloor{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};

TEST(CrossingDepth, OfACornerThroughAFaceIsHowFarItReaches) {
    const Corners pierces{Vec3(0, 0, -0.01), Vec3(-0.1, 0, 1), Vec3(0.1, 0, 1)};
    EXPECT_NEAR(crossingDepth(kFloor, pierces), 0.01, 1e-12);
    EXPECT_NEAR(crossingDepth(pierces, kFloor), 0.01, 1e-12);
}

TEST(CrossingDepth, OfTwoEdgesIsHowFarTheyPassEachOther) {
    const Corners upright{Vec3(-1, -1.02, -1), Vec3(1, -1.02, -1), Vec3(0, -0.96, 1)};
    const double depth = crossingDepth(kFloor, upright);
    EXPECT_GT(depth, 0);
    EXPECT_LT(depth, 0.02);
}

// One is bent away outside of the other: what lies there does not count.
TEST(CrossingDepth, OfNearlyParallelOnesIsThatWhereTheyLieOverEachOther) {
    const Corners beside{Vec3(-1, 0, 1e-9), Vec3(3, 0.1, -0.4), Vec3(3, -0.1, -0.4)};
    const Corners strip{Vec3(-3, -1, 0), Vec3(-0.999999, 0, 0), Vec3(-3, 1, 0)};
    EXPECT_LT(crossingDepth(strip, beside), 1e-5);
}

TEST(CrossingDepth, InOnePlaneIsZero) {
    EXPECT_EQ(crossingDepth(kFloor, kFloor), 0);
}

}  // namespace
}  // namespace kerf::repair
