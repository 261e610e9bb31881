#include "sim/cut/plan/air_edges.h"

#include <gtest/gtest.h>

#include "sim/cut/exact/piercing.h"
#include "sim/mesh/triangle.h"
#include "tests/support/shapes.h"
#include "tests/support/step_bench.h"

namespace kerf::cut {
namespace {

constexpr double kH = 0.3;
const Vec3 kShift(0.02, 0.15, -0.01);

/// A box of size 1 about the origin, and a rung along x above its top, all in the air.
class AirTiesOfABox : public ::testing::Test {
  protected:
    static std::vector<RungNode> rungAt(double height) {
        const double y = 0.5 + height;
        return {{{-0.3, y, 0.01}, 0, -1, false}, {{0.3, y, 0.01}, 1, -1, false}};
    }
    AirTies tiesOf(const std::vector<RungNode>& rung, SkinShape shape = SkinShape::current) {
        TriangleTree tree(mesh);
        return {mesh, tree, [](int) { return true; }, kH, rung, shape};
    }
    void move(const Vec3& way) {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            mesh.setPosition(v, mesh.position(v) + way);
        }
    }
    /// How much of the way of the skin a rung goes that is so high above it.
    double shareAt(double height) {
        std::vector<RungNode> rung = rungAt(height);
        const std::vector<RungNode> before = rung;
        const AirTies ties = tiesOf(rung);
        move(kShift);
        ties.follow(mesh, rung);
        move(-kShift);
        for (std::size_t i = 0; i < rung.size(); ++i) {
            const Vec3 way = rung[i].position - before[i].position;
            EXPECT_NEAR(way.cross(kShift).norm(), 0, 1e-12);
        }
        return (rung[0].position - before[0].position).dot(kShift) / kShift.squaredNorm();
    }

    SurfaceMesh mesh = test::box(Vec3::Ones(), 3);
};

TEST_F(AirTiesOfABox, GoWithTheSkinTheLessTheFartherOffItIs) {
    EXPECT_NEAR(shareAt(0.1 * kH), 1, 1e-9);
    EXPECT_NEAR(shareAt(0.99 * kH), 1, 1e-9);
    EXPECT_NEAR(shareAt(1.75 * kH), 0.5, 1e-9);
    EXPECT_NEAR(shareAt(2.6 * kH), 0, 1e-9);
}

TEST_F(AirTiesOfABox, LeaveVerticesToTheMesh) {
    std::vector<RungNode> rung = rungAt(0.1);
    rung[1].vertex = 5;
    const Vec3 before = rung[1].position;
    const AirTies ties = tiesOf(rung);
    move(kShift);
    ties.follow(mesh, rung);
    EXPECT_EQ(rung[1].position, before);
    EXPECT_NE(rung[0].position, rungAt(0.1)[0].position);
}

TEST_F(AirTiesOfABox, CarryPointsBetweenTheNodes) {
    const AirTies ties = tiesOf(rungAt(0.1));
    move(kShift);
    const std::vector<CarriedPoint> points = ties.between(mesh, 0);
    ASSERT_EQ(points.size(), 6U) << "0.3 h apart";
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 wanted(-0.3 + 0.6 * static_cast<double>(k + 1) / 7, 0.6, 0.01);
        EXPECT_LT((points[k].position - wanted - kShift).norm(), 1e-12);
        EXPECT_LT((points[k].outward - Vec3::UnitY()).norm(), 1e-12);
    }
}

TEST_F(AirTiesOfABox, OfAPartAreThoseOfItsEdges) {
    std::vector<RungNode> rung = rungAt(0.1);
    rung.insert(rung.begin() + 1, {{0, 0.6, 0.01}, 0.5, -1, false});
    const AirTies part = tiesOf(rung).part(1, 2, 4);
    EXPECT_TRUE(part.between(mesh, 0).empty());
    EXPECT_TRUE(part.between(mesh, 1).empty());
    ASSERT_EQ(part.between(mesh, 4).size(), 3U);
    EXPECT_GT(part.between(mesh, 4).front().position.x(), 0);
}

TEST_F(AirTiesOfABox, FrontEdgesAndGapsInTheFrontHaveNone) {
    std::vector<RungNode> rung = rungAt(0.1);
    std::vector<int> vertices;
    rung[0].attached = true;
    tiesOf(rung).addVertices(vertices);
    rung[0] = {rung[0].position, 0, 3, false};
    rung[1].vertex = 5;
    tiesOf(rung).addVertices(vertices);
    EXPECT_TRUE(vertices.empty());
}

// The body had moved before anybody asked.
TEST_F(AirTiesOfABox, AtRestHoldTheRungToWhereTheSkinRests) {
    std::vector<RungNode> rung = rungAt(0.1);
    move(kShift);
    tiesOf(rung, SkinShape::rest).follow(mesh, rung);
    EXPECT_LT((rung[0].position - rungAt(0.1)[0].position - kShift).norm(), 1e-12);
}

/// A rung above a box whose top may come up through it.
class AirEdgesAboveABox : public ::testing::Test {
  protected:
    /// The rung once it has been led around what has risen by so much.
    std::vector<RungNode> clearedAfter(double rise) {
        const Blade blade{{-0.8, 0.6, 0.01}, {0.8, 0.6, 0.02}};
        bench.begin(blade);
        TriangleTree tree(bench.mesh);
        const AirTies ties(
            bench.mesh, tree, [](int) { return true; }, kH, bench.rung(), SkinShape::current);
        for (int v = 0; v < bench.mesh.vertexCount(); ++v) {
            bench.mesh.setPosition(v, bench.mesh.position(v) + Vec3(0, rise, 0));
        }
        const Blade to{{-0.8, 0.3, 0.01}, {0.8, 0.3, 0.02}};
        const StepInput in = bench.stepTo(to);
        std::vector<RungNode> rung = in.rung;
        const auto give = [&]() -> const AirTies& {
            asked = true;
            return ties;
        };
        clearAirEdges(bench.mesh, in.broadPhase, in.opening, to, kH, give, rung);
        return rung;
    }
    bool isPierced(const std::vector<RungNode>& rung) const {
        const std::vector<int> living = livingTriangles(bench.mesh);
        for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
            const auto goesThrough = [&](int t) {
                return pierces(rung[i].position, rung[i + 1].position, cornersOf(bench.mesh, t));
            };
            if (std::ranges::any_of(living, goesThrough)) {
                return true;
            }
        }
        return false;
    }

    test::StepBench bench{test::box(Vec3::Ones(), 3), kH};
    bool asked = false;
};

TEST_F(AirEdgesAboveABox, StayWhereNothingIsInTheWay) {
    const std::vector<RungNode> rung = clearedAfter(0.05);
    EXPECT_EQ(rung.size(), 2U);
    EXPECT_FALSE(asked) << "for ties that are not needed";
}

TEST_F(AirEdgesAboveABox, GoAroundSkinThatHasRisenThroughThem) {
    const std::vector<RungNode> rung = clearedAfter(0.2);
    EXPECT_TRUE(asked);
    ASSERT_GT(rung.size(), 2U);
    EXPECT_TRUE(isPierced({rung.front(), rung.back()}));
    EXPECT_FALSE(isPierced(rung));
    EXPECT_EQ(rung.front().position, Vec3(-0.8, 0.6, 0.01));
    EXPECT_EQ(rung.back().position, Vec3(0.8, 0.6, 0.02));
    for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
        EXPECT_LT(rung[i].s, rung[i + 1].s);
        EXPECT_FALSE(rung[i].attached || rung[i].vertex >= 0);
    }
}

}  // namespace
}  // namespace kerf::cut
