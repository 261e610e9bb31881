// Where the lips of a cut are, and how large a hand is there.
#include "app/scene/incision.h"

#include <gtest/gtest.h>

#include "app/scene/timeline/hooks.h"
#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf::app {
namespace {

class IncisionTest : public test::SimulationTest {
  protected:
    /// A slit across the top of a ball, in the plane z = 0.013.
    void slitTo(double bottom) {
        simulation.emplace(test::icosphere(3), test::weightless());
        for (double y = 0.7; y > bottom; y -= 0.03) {
            simulation->execute(MoveBlade{{{-1, y, 0.013}, {1, y, 0.013}}});
            simulation->step();
        }
        simulation->execute(LiftBlade{});
        simulation->step();
    }
    static Vec3 beside(double z) { return Vec3(0.02, 0.5, z).normalized() * 0.5; }
};

TEST_F(IncisionTest, LipsLieOnBothSidesThePressedOneFirst) {
    slitTo(0.1);
    for (const int side : {1, -1}) {
        const auto found = incisionNear(simulation->mesh(), beside(0.08 * side), 0.2);
        ASSERT_TRUE(found);
        EXPECT_GT(side * (found->lips[0].z() - 0.013), 0);
        EXPECT_LT(side * (found->lips[1].z() - 0.013), 0);
        EXPECT_LT((found->lips[0] - found->lips[1]).norm(), 0.15) << "they face each other";
        EXPECT_LT(side * found->across.z(), -0.97) << "from the pressed one to the other";
        EXPECT_NEAR(found->away, 0.079 - 0.013 * side, 0.01);
        EXPECT_NEAR(found->gap, 0, 0.01);
        EXPECT_NEAR(found->length, 1.06, 0.1) << "of the arc's box: 2 * 0.49 wide, 0.4 high";
    }
}

TEST_F(IncisionTest, NoneIsFoundWithoutACutOrBeyondTheReach) {
    slitTo(0.1);
    EXPECT_FALSE(incisionNear(simulation->mesh(), Vec3(0, -0.5, 0), 0.2));
    EXPECT_FALSE(incisionNear(test::icosphere(2), beside(0.08), 10));
}

TEST_F(IncisionTest, AHandIsSmallerWhereALipOrAPieceIs) {
    slitTo(0.35);
    const SurfaceMesh& mesh = simulation->mesh();
    const Bounds body = simulation->bounds();
    const double atLip = handRadius(mesh, beside(0.06), 0.3, body);
    EXPECT_LT(atLip, 0.2);
    EXPECT_GT(atLip, 0.08);
    EXPECT_EQ(handRadius(mesh, Vec3(0, -0.5, 0), 0.3, body), 0.3) << "no cut is near";
    Bounds crumb;
    crumb.add(Vec3(0, -0.5, 0));
    crumb.add(Vec3(0.1, -0.4, 0));
    EXPECT_LT(handRadius(mesh, Vec3(0, -0.5, 0), 0.3, crumb), 0.05);
}

TEST(Hooks, AreTwoHandsOfARetractor) {
    EXPECT_EQ(partnerOf(kFirstHook), kFirstHook + 1);
    EXPECT_EQ(partnerOf(kFirstHook + 1), kFirstHook);
    std::vector<Hands::Hand> hands(3);
    hands[1].number = kFirstHook + 1;
    hands[2].number = kFirstHook + 2;
    EXPECT_EQ(hooksOf(hands).size(), 2U);
    EXPECT_EQ(freeRetractor(hands), kFirstHook + 4);
    hands.clear();
    for (int number = kFirstHook; number <= kLastHook; ++number) {
        hands.emplace_back().number = number;
    }
    EXPECT_EQ(freeRetractor(hands), std::nullopt);
}

}  // namespace
}  // namespace kerf::app
