#include "sim/repair/hole_filling.h"

#include "sim/repair/polygon_triangles.h"
#include "sim/repair/surface_contact.h"

namespace kerf::repair {
namespace {

/// Without the triangles for which `gone` holds of their middle.
template <class Gone>
TriangleSoup withHoleAt(const TriangleSoup& soup, Gone&& gone) {
    TriangleSoup rest = soup;
    std::erase_if(rest.triangles, [&](const Triangle& t) {
        return gone((soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]]) / 3);
    });
    return weldExactly(rest);
}

TEST(HoleFilling, AClosedSurfaceStaysAsItIs) {
    TriangleSoup soup = weldExactly(boxSoup());
    const HoleFilling done = fillHoles(soup);
    EXPECT_EQ(done.holes, 0);
    EXPECT_EQ(soup.triangles.size(), 12U);
}

TEST(HoleFilling, TheLidOfABoxComesBackFlat) {
    // The border has points on straight lines, where no triangle may be without area.
    TriangleSoup soup =
        withHoleAt(boxSoup(Vec3::Ones(), 4), [](const Vec3& m) { return m.y() > 0.49; });
    ASSERT_EQ(inspectTriangles(soup).openEdges, 16);
    const HoleFilling done = fillHoles(soup);
    EXPECT_EQ(done.holes, 1);
    EXPECT_EQ(done.triangles, 14);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_NEAR(report.volume, 1, 1e-12);
}

TEST(HoleFilling, BothEndsOfATubeAreFilled) {
    TriangleSoup soup =
        withHoleAt(cubeSphereSoup(8, 0.5), [](const Vec3& m) { return std::abs(m.x()) > 0.35; });
    const HoleFilling done = fillHoles(soup);
    EXPECT_EQ(done.holes, 2);
    const MeshReport report = inspectTriangles(soup);
    EXPECT_TRUE(report.cuttable) << report.problem;
    EXPECT_LT(report.volume, 4.0 / 3 * std::numbers::pi * 0.125);
    EXPECT_GT(report.volume, 0.4);
}

TEST(HoleFilling, ASingleMissingTriangleIsPutBack) {
    TriangleSoup soup = weldExactly(icosphereSoup(1));
    const Triangle gone = soup.triangles.back();
    soup.triangles.pop_back();
    EXPECT_EQ(fillHoles(soup).triangles, 1);
    Triangle back = soup.triangles.back();
    while (back[0] != gone[0]) {
        std::rotate(back.begin(), back.begin() + 1, back.end());
    }
    EXPECT_EQ(back, gone);
}

TEST(HoleFilling, HolesThatTouchInAVertexStayOpen) {
    TriangleSoup soup;  // an octahedron without two triangles that share the top alone
    soup.positions = {Vec3(1, 0, 0),  Vec3(0, 0, 1), Vec3(-1, 0, 0),
                      Vec3(0, 0, -1), Vec3(0, 1, 0), Vec3(0, -1, 0)};
    soup.triangles = {{1, 2, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
    ASSERT_EQ(inspectTriangles(soup).openEdges, 6);
    EXPECT_EQ(fillHoles(soup).holes, 0);
    EXPECT_EQ(soup.triangles.size(), 6U);
}

using Polygon = std::vector<Vec3>;

constexpr unsigned kStarSeed = 20261126;

Vec3 areaVector(const Polygon& corners, const Triangle& t) {
    return (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]) / 2;
}

/// The triangles cover the area of a flat polygon that faces along `normal`,
/// and none lies on its back.
void expectDivided(const Polygon& corners, const Vec3& normal, double area) {
    const std::vector<Triangle> triangles = repair::triangulatePolygon(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    double sum = 0;
    for (const Triangle& t : triangles) {
        const double part = areaVector(corners, t).dot(normal);
        EXPECT_GT(part, 0);
        sum += part;
    }
    EXPECT_NEAR(sum, area, 1e-12 * std::max(1.0, area));
}

TEST(PolygonTriangles, AnLWhoseReflexCornerLiesOnTheSideOfAnEar) {
    const Polygon ell{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    expectDivided(ell, Vec3::UnitZ(), 3);
    const Polygon back(ell.rbegin(), ell.rend());
    expectDivided(back, -Vec3::UnitZ(), 3);
    for (std::size_t first = 1; first < ell.size(); ++first) {
        Polygon turned = ell;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                    turned.end());
        expectDivided(turned, Vec3::UnitZ(), 3);
    }
}

TEST(PolygonTriangles, CornersOnStraightSidesStay) {
    expectDivided({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}},
                  Vec3::UnitZ(), 4);
}

TEST(PolygonTriangles, StarsInAnyPlaneAreCoveredOnce) {
    std::mt19937 random(kStarSeed);
    std::uniform_real_distribution<double> radius(0.05, 1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int run = 0; run < 100; ++run) {
        SCOPED_TRACE(testing::Message() << "seed " << kStarSeed << ", run " << run);
        const int count = 5 + static_cast<int>(random() % 60);
        Polygon star;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            star.emplace_back(radius(random) * Vec3(std::cos(angle), std::sin(angle), 0));
        }
        double area = 0;
        for (int i = 0; i < count; ++i) {
            area += star[i].cross(star[(i + 1) % count]).z() / 2;
        }
        const Vec3 axis = Vec3(any(random), any(random), any(random)).normalized();
        const Eigen::AngleAxisd turn(3 * any(random), axis);
        for (Vec3& p : star) {
            p = turn * p;
        }
        expectDivided(star, turn * Vec3::UnitZ(), area);
    }
}

TEST(PolygonTriangles, AnEdgeMayLeadToAHoleAndBack) {
    const Polygon frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    expectDivided(frame, Vec3::UnitZ(), 12);
}

TEST(PolygonTriangles, OfABentOneNoCornerIsLost) {
    // Two sides of a cube as one polygon, with corners that hide others along each axis.
    const Polygon bent{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 1, 0}};
    EXPECT_EQ(repair::triangulatePolygon(bent).size(), 4u);
}

TEST(PolygonTriangles, WhatCrossesItselfOrIsFlatHasNone) {
    EXPECT_TRUE(repair::triangulatePolygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
    EXPECT_TRUE(repair::triangulatePolygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}).empty());
    Polygon pentagram;
    for (int i = 0; i < 5; ++i) {
        const double angle = 4 * std::numbers::pi * i / 5;
        pentagram.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_TRUE(repair::triangulatePolygon(pentagram).empty());
}

TEST(PolygonTriangles, WhatTouchesItselfHasNone) {
    // The fifth corner lies on the first side.
    EXPECT_TRUE(repair::triangulatePolygon(
                    {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {3, 2, 0}, {2, 0, 0}, {0, 2, 0}})
                    .empty());
}

const Line kLine{Vec3(0, 0, 0), Vec3(0, 0, 1)};

/// A face in a direction about the line [degrees], with its point somewhere along it.
Vec3 face(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle), 0.3};
}

TEST(Wedge, ThoseThatOverlapInPartCross) {
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(50), face(160)}));
    EXPECT_TRUE(wedgesCross(kLine, {face(300), face(20)}, {face(10), face(100)}));
}

TEST(Wedge, ThoseThatAreApartOrWithinOneAnotherOnlyTouch) {
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(150), face(300)}));
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(40), face(60)}));
    // A hollow whose edge touches the skin from within: the material is all around it.
    EXPECT_FALSE(wedgesCross(kLine, {face(60), face(40)}, {face(10), face(100)}));
}

TEST(Wedge, AFaceInCommonCrossesWhereTheMaterialIsOnItsSameSide) {
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(10), face(50)}));
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(50), face(100)}));
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(100), face(200)}));
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(100)}, {face(100), face(10)}));
    EXPECT_TRUE(wedgesCross(kLine, {face(10), face(100)}, {face(100), face(50)}))
        << "goes on into the other one";
}

TEST(Wedge, WithoutAnAngleNothingIsSaid) {
    EXPECT_FALSE(wedgesCross(kLine, {face(10), face(10)}, {face(0), face(50)}));
    EXPECT_FALSE(wedgesCross(kLine, {Vec3(0, 0, 2), face(10)}, {face(0), face(50)}));
}

/// How far a direction is turned from another one [steps of a whole turn of 12].
int turned(int from, int to) {
    return (to - from + 12) % 12;
}

bool within(int x, int from, int to) {
    return turned(from, x) > 0 && turned(from, x) < turned(from, to);
}

/// Whether some twelfth of the turn is in both, and neither is whole within the other.
bool overlapInPart(int a, int toA, int b, int toB) {
    const auto holds = [](int from, int to, int i) { return turned(from, i) < turned(from, to); };
    bool both = false;
    for (int i = 0; i < 12; ++i) {
        both = both || (holds(a, toA, i) && holds(b, toB, i));
    }
    const bool nested =
        (within(b, a, toA) && within(toB, a, toA)) || (within(a, b, toB) && within(toA, b, toB));
    return both && !nested;
}

TEST(Wedge, AllOfTwelfthsOfATurnAreAsCountingSays) {
    // Whole numbers, so that opposite directions are exact.
    constexpr std::array<std::array<int, 2>, 12> kDirections{{{2, 0},
                                                              {2, 1},
                                                              {1, 2},
                                                              {0, 2},
                                                              {-1, 2},
                                                              {-2, 1},
                                                              {-2, 0},
                                                              {-2, -1},
                                                              {-1, -2},
                                                              {0, -2},
                                                              {1, -2},
                                                              {2, -1}}};
    std::mt19937 random(20261126);
    const Line line{Vec3(1, 2, 3), Vec3(3, 3, 7)};
    const Vec3 axis = line.v - line.u;
    const Vec3 x(1, -2, 0);
    const Vec3 y = axis.cross(x);
    const auto place = [&](int i) {
        const double far = 1 + static_cast<double>(random() % 3);
        return Vec3(line.u + static_cast<double>(random() % 5) * axis +
                    far * (kDirections[i][0] * x + kDirections[i][1] * y));
    };
    for (int i = 0; i < 12 * 12 * 12 * 12; ++i) {
        const int a = i % 12;
        const int toA = i / 12 % 12;
        const int b = i / 144 % 12;
        const int toB = i / 1728;
        if (a != toA && b != toB) {
            ASSERT_EQ(wedgesCross(line, {place(a), place(toA)}, {place(b), place(toB)}),
                      overlapInPart(a, toA, b, toB))
                << a << " to " << toA << ", " << b << " to " << toB;
        }
    }
}

}  // namespace
}  // namespace kerf::repair
