#include "sim/cut/exact/triangulation.h"

#include "sim/base/predicates.h"

namespace kerf::cut {
namespace {

constexpr std::uint64_t kSeed = 77;

class RandomPoints {
  public:
    Vec2 next() {
        const double x = uniform();
        const double y = uniform();
        return x + y < 1 ? Vec2(x, y) : Vec2(1 - x, 1 - y);
    }

  private:
    double uniform() { return 0.001 + 0.998 * static_cast<double>(engine_() >> 11) * 0x1p-53; }
    std::mt19937_64 engine_{kSeed};
};

Triangulation unitTriangle() {
    return {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
}

double areaOf(const Triangulation& plane) {
    double area = 0;
    for (int t = 0; t < plane.size(); ++t) {
        const Triangle& c = plane.corners(t);
        const Vec2 u = plane.point(c[1]) - plane.point(c[0]);
        const Vec2 v = plane.point(c[2]) - plane.point(c[0]);
        EXPECT_EQ(orient2d(plane.point(c[0]), plane.point(c[1]), plane.point(c[2])), 1);
        area += 0.5 * (u.x() * v.y() - u.y() * v.x());
    }
    return area;
}

void expectNeighborsMutual(const Triangulation& plane) {
    for (int t = 0; t < plane.size(); ++t) {
        for (int e = 0; e < 3; ++e) {
            const int other = plane.neighbor(t, e);
            if (other < 0) {
                continue;
            }
            const int f = plane.mirrorEdge(t, e);
            EXPECT_EQ(plane.neighbor(other, f), t);
            EXPECT_EQ(plane.corners(other)[f], plane.corners(t)[(e + 1) % 3]);
            EXPECT_EQ(plane.corners(other)[(f + 1) % 3], plane.corners(t)[e]);
            EXPECT_EQ(plane.constrained(other, f), plane.constrained(t, e));
        }
    }
}

bool hasEdge(const Triangulation& plane, int a, int b, bool constrainedOnly) {
    for (int t = 0; t < plane.size(); ++t) {
        for (int e = 0; e < 3; ++e) {
            const int from = plane.corners(t)[e];
            const int to = plane.corners(t)[(e + 1) % 3];
            if (((from == a && to == b) || (from == b && to == a)) &&
                (!constrainedOnly || plane.constrained(t, e))) {
                return true;
            }
        }
    }
    return false;
}

/// Both angles opposite of an edge, of which Delaunay edges have at most pi [rad].
double oppositeAngles(const Triangulation& plane, int t, int e) {
    const Triangle& c = plane.corners(t);
    const Vec2& a = plane.point(c[e]);
    const Vec2& b = plane.point(c[(e + 1) % 3]);
    const auto angleAt = [&](const Vec2& p) {
        const Vec2 u = a - p;
        const Vec2 v = b - p;
        return std::acos(u.dot(v) / (u.norm() * v.norm()));
    };
    return angleAt(plane.point(c[(e + 2) % 3])) + angleAt(plane.point(plane.oppositeVertex(t, e)));
}

/// Edges that are no constraint and would be better flipped, each from both of its sides.
int edgesToFlip(const Triangulation& plane) {
    int count = 0;
    for (int t = 0; t < plane.size(); ++t) {
        for (int e = 0; e < 3; ++e) {
            count += plane.neighbor(t, e) >= 0 && plane.convex(t, e) && !plane.constrained(t, e) &&
                     oppositeAngles(plane, t, e) > std::numbers::pi + 1e-6;
        }
    }
    return count;
}

TEST(Triangulation, FillsTheTriangleWithPositiveTriangles) {
    Triangulation plane = unitTriangle();
    RandomPoints points;
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(plane.insert(points.next()).vertex, 3 + i);
    }
    EXPECT_EQ(plane.size(), 1 + 2 * 200);
    EXPECT_NEAR(areaOf(plane), 0.5, 1e-12);
    expectNeighborsMutual(plane);
}

TEST(Triangulation, NoVertexLiesInACircumcircle) {
    Triangulation plane = unitTriangle();
    RandomPoints points;
    for (int i = 0; i < 60; ++i) {
        plane.insert(points.next());
    }
    EXPECT_EQ(edgesToFlip(plane), 0);
}

TEST(Triangulation, OnlyAConstraintIsNoDelaunayEdge) {
    Triangulation plane = unitTriangle();
    const int a = plane.insert({0.05, 0.06}).vertex;
    const int b = plane.insert({0.82, 0.11}).vertex;
    RandomPoints points;
    for (int i = 0; i < 80; ++i) {
        plane.insert(points.next());
    }
    ASSERT_FALSE(hasEdge(plane, a, b, false));
    EXPECT_TRUE(plane.constrain(a, b));
    EXPECT_EQ(edgesToFlip(plane), 0);
}

TEST(Triangulation, ConstraintsBecomeEdgesAndStay) {
    Triangulation plane = unitTriangle();
    RandomPoints points;
    const int a = plane.insert({0.05, 0.06}).vertex;
    const int b = plane.insert({0.82, 0.11}).vertex;
    const int c = plane.insert({0.11, 0.83}).vertex;
    for (int i = 0; i < 80; ++i) {
        plane.insert(points.next());
    }
    EXPECT_TRUE(plane.constrain(a, b));
    EXPECT_TRUE(plane.constrain(b, c));
    EXPECT_TRUE(plane.constrain(c, a));
    for (int i = 0; i < 80; ++i) {
        plane.insert(points.next());
    }
    EXPECT_TRUE(hasEdge(plane, a, b, true));
    EXPECT_TRUE(hasEdge(plane, b, c, true));
    EXPECT_TRUE(hasEdge(plane, c, a, true));
    EXPECT_NEAR(areaOf(plane), 0.5, 1e-12);
    expectNeighborsMutual(plane);
}

TEST(Triangulation, RefusesCrossingConstraints) {
    Triangulation plane = unitTriangle();
    const int a = plane.insert({0.1, 0.1}).vertex, b = plane.insert({0.4, 0.4}).vertex;
    const int c = plane.insert({0.1, 0.4}).vertex, d = plane.insert({0.4, 0.1}).vertex;
    EXPECT_TRUE(plane.constrain(a, b));
    EXPECT_FALSE(plane.constrain(c, d));
    EXPECT_FALSE(plane.constrain(a, a));
}

TEST(Triangulation, RefusesAConstraintThroughAVertex) {
    Triangulation plane = unitTriangle();
    const int a = plane.insert({0.125, 0.125}).vertex;
    plane.insert({0.25, 0.25});
    const int b = plane.insert({0.375, 0.375}).vertex;
    EXPECT_FALSE(plane.constrain(a, b));
}

TEST(Triangulation, FindsExistingVerticesAndPointsOutside) {
    Triangulation plane = unitTriangle();
    const int a = plane.insert({0.25, 0.25}).vertex;
    const Triangulation::Insertion again = plane.insert({0.25, 0.25});
    EXPECT_TRUE(again.existed);
    EXPECT_EQ(again.vertex, a);
    EXPECT_EQ(plane.insert({0.8, 0.8}).vertex, -1);
    EXPECT_EQ(plane.size(), 3);
}

TEST(Triangulation, PointsOnTheBorderSplitIt) {
    Triangulation plane = unitTriangle();
    for (const Vec2& p : {Vec2(0.5, 0), Vec2(0.5, 0.5), Vec2(0, 0.5)}) {
        EXPECT_FALSE(plane.insert(p).existed);
    }
    EXPECT_EQ(plane.size(), 4);
    EXPECT_NEAR(areaOf(plane), 0.5, 1e-15);
}

TEST(Triangulation, MarksAreHandedDown) {
    Triangulation plane = unitTriangle();
    plane.setMarked(0, true);
    plane.insert({0.3, 0.3});
    plane.insert({0.5, 0.0});
    for (int t = 0; t < plane.size(); ++t) {
        EXPECT_TRUE(plane.marked(t));
    }
}

}  // namespace
}  // namespace kerf::cut
