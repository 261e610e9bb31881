// Short edges that a cut left go where the body stays folded.
#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/body/folded_triangles.h"
#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

constexpr double kMendedSize = 0.5;
constexpr double kEdge = 0.1;  // about that of the sphere [m]

struct ShortEdge {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
};

class MendingTest : public test::SimulationTest {
  protected:
    void SetUp() override {
        SimulationTest::SetUp();
        const SurfaceMesh mesh = test::cubeSphere(8, kMendedSize);
        uncutTriangles = mesh.triangleSlots();
        Params params = test::weightless();
        simulation.emplace(mesh, params);
        for (int i = 0; i <= 40; ++i) {
            const double y = 0.7 - 1.4 * i / 40;
            simulation->execute(MoveBlade{{{0.02, y, -1}, {0.02, y, 1}}});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        run(10);
    }

    /// That the cut made and left.
    ShortEdge shortEdge() {
        const SurfaceMesh& mesh = simulation->mesh();
        for (int h = 3 * uncutTriangles; h < 3 * mesh.triangleSlots(); ++h) {
            if (mesh.alive(h / 3)) {
                ShortEdge edge{mesh.position(mesh.origin(h)), mesh.position(mesh.target(h))};
                const double length = (edge.to - edge.from).norm();
                if (length > 0.08 * kEdge && length < 0.15 * kEdge) {
                    return edge;
                }
            }
        }
        throw std::logic_error("the cut left no short edge");
    }
    /// A hand holds one end of a short edge beyond the other.
    void fold() {
        const ShortEdge edge = shortEdge();
        ASSERT_EQ(simulation->execute(Grab{0, edge.from, 1e-3 * kEdge}), "");
        const Vec3 beyond = edge.to + 4 * kEdge * (edge.to - edge.from).normalized();
        ASSERT_EQ(simulation->execute(Drag{0, beyond}), "");
        simulation->step();
    }
    bool isFolded() { return !foldedTriangles(simulation->mesh(), uncutTriangles).empty(); }
    int triangles() { return simulation->mesh().aliveTriangles(); }

    int uncutTriangles = 0;
};

TEST_F(MendingTest, WhatStaysFoldedLosesItsShortEdges) {
    ASSERT_FALSE(isFolded());
    const int before = triangles();
    fold();
    run(5);
    EXPECT_TRUE(isFolded());
    EXPECT_EQ(triangles(), before) << "most folds go by themselves";
    run(40);
    EXPECT_LT(triangles(), before);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
    EXPECT_NEAR(simulation->report().volumeRatio, 1, 1e-3);
}

TEST_F(MendingTest, WhatLiesUnfoldedKeepsThem) {
    const int before = triangles();
    run(80);
    EXPECT_EQ(triangles(), before);
}

TEST_F(MendingTest, AMomentKnowsHowLongTheBodyHasBeenFolded) {
    const int before = triangles();
    fold();
    run(5);
    const Moment folded = simulation->moment();
    run(40);
    const std::string mended = simulation->stateHash();
    EXPECT_LT(triangles(), before);
    simulation->goTo(folded);
    EXPECT_EQ(triangles(), before);
    run(40);
    EXPECT_EQ(simulation->stateHash(), mended);
}

}  // namespace
}  // namespace kerf
