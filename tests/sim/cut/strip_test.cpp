#include "sim/cut/stroke/rung_parts.h"

namespace kerf::cut {
namespace {

/// Two rungs between x = 0 and x = 1; nodes of the lower one first.
struct Rungs {
    std::vector<int> lower, upper;
    std::vector<double> lowerS, upperS;
    std::vector<Vec2> at;
};

void addLower(Rungs& rungs, double s, double y = 0) {
    rungs.lower.push_back(static_cast<int>(rungs.at.size()));
    rungs.lowerS.push_back(s);
    rungs.at.push_back({s, y});
}

void addUpper(Rungs& rungs, double s, double y = 1) {
    rungs.upper.push_back(static_cast<int>(rungs.at.size()));
    rungs.upperS.push_back(s);
    rungs.at.push_back({s, y});
}

Rungs randomRungs(std::mt19937_64& engine, bool pinStart, bool pinEnd) {
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
    };
    Rungs rungs;
    const int below = between(1, 8), above = between(1, 8);
    for (int i = 0; i <= below; ++i) {
        addLower(rungs, i / static_cast<double>(below));
    }
    for (int j = 0; j <= above; ++j) {
        const bool pinned = (j == 0 && pinStart) || (j == above && pinEnd);
        if (pinned) {
            rungs.upper.push_back(j == 0 ? rungs.lower.front() : rungs.lower.back());
            rungs.upperS.push_back(j == 0 ? 0 : 1);
        } else {
            addUpper(rungs, j / static_cast<double>(above));
        }
    }
    return rungs;
}

bool allOn(const Triangle& t, const std::vector<int>& rung) {
    return std::all_of(t.begin(), t.end(), [&](int node) {
        return std::find(rung.begin(), rung.end(), node) != rung.end();
    });
}

double signedArea(const Rungs& rungs, const Triangle& t) {
    const Vec2 u = rungs.at[t[1]] - rungs.at[t[0]];
    const Vec2 v = rungs.at[t[2]] - rungs.at[t[0]];
    return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

double polygonArea(const Rungs& rungs) {
    std::vector<Vec2> border;
    for (const int node : rungs.lower) {
        border.push_back(rungs.at[node]);
    }
    for (int j = static_cast<int>(rungs.upper.size()) - 1; j >= 0; --j) {
        border.push_back(rungs.at[rungs.upper[j]]);
    }
    double area = 0;
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec2& p = border[i];
        const Vec2& q = border[(i + 1) % border.size()];
        area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    return area;
}

void expectGoodZip(const Rungs& rungs) {
    const std::vector<Triangle> triangles =
        stitch(rungs.lower, rungs.lowerS, rungs.upper, rungs.upperS);
    double area = 0;
    for (const Triangle& t : triangles) {
        EXPECT_FALSE(allOn(t, rungs.lower)) << "three nodes on the old rung";
        EXPECT_FALSE(allOn(t, rungs.upper)) << "three nodes on the new rung";
        EXPECT_GT(signedArea(rungs, t), 0);
        area += signedArea(rungs, t);
    }
    EXPECT_NEAR(area, polygonArea(rungs), 1e-12);
}

TEST(Strip, ZipCoversTheBand) {
    std::mt19937_64 engine(5);
    for (int i = 0; i < 200; ++i) {
        expectGoodZip(randomRungs(engine, false, false));
    }
}

TEST(Strip, ZipWithAPinnedEndLeavesNoTriangleOnOneRung) {
    std::mt19937_64 engine(6);
    for (int i = 0; i < 200; ++i) {
        expectGoodZip(randomRungs(engine, true, false));
        expectGoodZip(randomRungs(engine, false, true));
    }
}

TEST(Strip, ZipWithBothEndsPinnedCoversALens) {
    Rungs rungs;
    addLower(rungs, 0);
    addLower(rungs, 0.3, -0.2);
    addLower(rungs, 0.7, -0.2);
    addLower(rungs, 1);
    rungs.upper = {rungs.lower.front()};
    rungs.upperS = {0};
    addUpper(rungs, 0.5, 0.3);
    rungs.upper.push_back(rungs.lower.back());
    rungs.upperS.push_back(1);
    expectGoodZip(rungs);
}

// The strip would fold back behind a front whose end is steep, and cut the walls there again.
TEST(Strip, AnInnerFrontNodeIsJoinedToThePointAboveItNotToTheEndOfTheBlade) {
    const std::vector<Triangle> triangles =
        stitch({0, 1, 2, 3, 4}, {0, 0.55, 0.56, 0.64, 1}, {5, 6, 7}, {0, 0.56, 1});
    for (const Triangle& t : triangles) {
        const auto has = [&](int node) { return std::find(t.begin(), t.end(), node) != t.end(); };
        EXPECT_FALSE(has(2) && (has(5) || has(7)));
    }
}

constexpr double kRungH = 0.1;
constexpr double kGate = 0.5 * kRungH;
const Vec3 kHeading = Vec3::UnitX();

/// Along y from 0 to 1; the front lies between 0.2 and 0.8.
std::vector<RungNode> shortRungAlongY() {
    std::vector<RungNode> rung{{{0, 0, 0}, 0, -1, false}};
    for (int i = 2; i <= 8; ++i) {
        rung.push_back({{0, 0.1 * i, 0}, 0.1 * i, i, i < 8});
    }
    rung.push_back({{0, 1, 0}, 1, -1, false});
    return rung;
}

std::vector<RungPart> partsTo(double ofA, double ofB) {
    return partsAhead({{ofA, 0, 0}, {ofB, 1, 0}}, kRungH, kGate, kHeading, shortRungAlongY());
}

TEST(RungParts, ABladeThatIsAheadEverywhereTakesTheWholeRung) {
    const std::vector<RungPart> parts = partsTo(kRungH, 2 * kRungH);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].first, 0);
    EXPECT_EQ(parts[0].rung.size(), shortRungAlongY().size());
    EXPECT_FALSE(parts[0].span.holdsFrom || parts[0].span.holdsTo);
    EXPECT_EQ(parts[0].span.from, 0);
    EXPECT_EQ(parts[0].span.to, 1);
}

// It crosses the rung at 0.5, in the front.
TEST(RungParts, APartEndsAtAnInnerNodeOfTheFrontWhichStays) {
    const std::vector<RungPart> parts = partsTo(-3 * kRungH, 3 * kRungH);
    ASSERT_EQ(parts.size(), 1U);
    const RungNode& held = parts[0].rung.front();
    EXPECT_EQ(held.vertex, 5);
    EXPECT_EQ(parts[0].span.from, held.s);
    EXPECT_TRUE(parts[0].span.holdsFrom);
    EXPECT_FALSE(parts[0].span.holdsTo);
    EXPECT_EQ(parts[0].first + parts[0].count, static_cast<int>(shortRungAlongY().size()));
}

// At 0.1, beside the front.
TEST(RungParts, APartEndsInTheAirWhereTheBladeCrossesTheRung) {
    const std::vector<RungPart> parts = partsTo(-kRungH, 9 * kRungH);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_LT(parts[0].rung.front().vertex, 0);
    EXPECT_NEAR(parts[0].rung.front().s, 0.1, 1e-12);
    EXPECT_EQ(parts[0].rung[1].vertex, 2);
    EXPECT_EQ(parts[0].first, 1) << "the node at the blade's end stays";
}

TEST(RungParts, BelowTheGateNothingGoesOn) {
    EXPECT_TRUE(partsTo(-3 * kRungH, 0.4 * kRungH).empty());
    EXPECT_TRUE(partsTo(-3 * kRungH, -kRungH).empty());
}

TEST(RungParts, WhatGoesOnTakesThePlaceOfThePart) {
    const std::vector<RungNode> rung = shortRungAlongY();
    const RungPart part = partsTo(-3 * kRungH, 3 * kRungH).front();
    const std::vector<RungNode> next{{{0, 0.5, 0}, 0.5, 5, true}, {{0.1, 0.9, 0}, 0.9, 9, false}};
    const std::vector<RungNode> after = replaced(rung, part, next);
    ASSERT_EQ(static_cast<int>(after.size()), part.first + 2);
    EXPECT_EQ(after[part.first - 1].vertex, rung[part.first - 1].vertex);
    EXPECT_TRUE(after[part.first - 1].attached);
    EXPECT_EQ(after.back().vertex, 9);
    for (const RungNode& node : stayingFront(rung, part)) {
        EXPECT_FALSE(node.attached && node.vertex >= 5) << node.vertex;
    }
}

Vec3 advanceBy(const Vec3& way) {
    return advanceOf({way, Vec3::UnitY() + way}, kRungH, shortRungAlongY(), shortRungAlongY());
}

// A front that moves along with the blade slips past it anywhere.
TEST(RungParts, AShortWayTellsNoDirection) {
    EXPECT_EQ(advanceBy({0.1 * kRungH, 0, 0.2 * kRungH}), Vec3(Vec3::Zero()));
    EXPECT_GT(advanceBy({0.4 * kRungH, 0, 0.2 * kRungH}).x(), 0);
}

double wallArea(const SurfaceMesh& mesh) {
    double area = 0;
    for (const int t : livingTriangles(mesh)) {
        area += mesh.kind(t) == SurfaceKind::wall ? triangleArea(cornersOf(mesh, t)) : 0;
    }
    return area;
}

/// In the plane z = 0.013 right through a sphere of radius 0.5; the blade tilts by up to `tilt`
/// about its middle.
Stroke rockingStroke(double tilt) {
    Stroke stroke;
    for (int i = 0; i <= 90; ++i) {
        const double u = i / 90.0 - 0.5;
        const double angle = tilt * std::sin(40 * u);
        const Vec3 along(std::sin(angle), std::cos(angle), 0);
        const Vec3 middle(1.6 * u, 0.021, 0.013);
        stroke.push_back({middle - 1.5 * along, middle + 1.5 * along});
    }
    return stroke;
}

// What goes back lies in the slit: no wall is made twice.
TEST(RungParts, ARockingBladeMakesTheWallsOfAStraightOne) {
    constexpr double kTilt =
        0.25;  // the ends of the slit go back by twice what the middle advances
    SurfaceMesh straight = icosphere(3);
    runStroke(straight, exactSettings(), rockingStroke(0));
    SurfaceMesh rocking = icosphere(3);
    const CutCheck check = runStroke(rocking, exactSettings(), rockingStroke(kTilt));
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.unmirrored, "");
    EXPECT_EQ(check.refused, 0) << check.reason;
    EXPECT_EQ(findPieces(rocking).pieces.size(), 2U);
    EXPECT_EQ(slitEdges(rocking, 0), 0);
    EXPECT_NEAR(wallArea(rocking), wallArea(straight), 1e-4 * wallArea(straight));
    EXPECT_TRUE(selfIntersections(opened(rocking, 1e-6 * kRungH)).empty());
}

void expectAllPart(FuzzMode mode, std::uint64_t firstSeed, int runs) {
    SCOPED_TRACE("first seed " + std::to_string(firstSeed));
    FuzzReport report;
    for (int i = 0; i < runs; ++i) {
        fuzzOnce(firstSeed + i, report, mode);
    }
    for (const FuzzSetting setting : kFuzzSettings) {
        const FuzzFigures sum = report.total(setting);
        EXPECT_GT(sum.strokes, 0);
        EXPECT_EQ(sum.refused, 0) << "of " << sum.cuts << " steps";
        EXPECT_EQ(sum.unseparated, 0) << "of " << sum.strokes << " strokes";
        EXPECT_EQ(sum.unmirrored, 0);
        EXPECT_EQ(sum.invalid, 0);
        EXPECT_LE(sum.intersecting, 0.03 * sum.strokes);
    }
}

TEST(RungParts, RandomRockingStrokesPart) {
    expectAllPart(FuzzMode::rocking, 500000, 60);
}

TEST(RungParts, RandomSlicingStrokesPart) {
    expectAllPart(FuzzMode::slicing, 520000, 60);
}

}  // namespace
}  // namespace kerf::cut
