// A hollow body as the solver sees it.
#include <gmock/gmock.h>

#include "sim/body/body_model.h"
#include "sim/mesh/invariants.h"
#include "tests/support/shapes.h"
#include "tests/support/simulation_fixture.h"

namespace kerf {
namespace {

class HollowBodyTest : public test::SimulationTest {
  protected:
    SurfaceMesh ball =
        test::hollow(test::icosphereSoup(3, 0.5), test::icosphereSoup(2, 0.25), Vec3::Zero());
    Vec3 middle{0.013, 0.021, 0.034};

    void cut() {
        const Vec3 half(1.5, 0, 0);
        for (int i = 0; i <= 40; ++i) {
            const Vec3 at = middle + Vec3(0, 1.2 - 0.06 * i, 0);
            simulation->execute(MoveBlade{{at - half, at + half}});
            run(1);
        }
        simulation->execute(LiftBlade{});
        run(1);
    }
};

TEST_F(HollowBodyTest, IspcsEndAtTheCavity) {
    simulation.emplace(ball, test::weightless());
    const BodyModel& model = simulation->bodyModel();
    EXPECT_EQ(model.pieces.size(), 1u);
    ASSERT_GT(model.ispcs.size(), 500u);
    int onSkin = 0;
    for (const IspcConstraint& ispc : model.ispcs) {
        // Through the wall, or as a chord beside the cavity.
        const double beside = 0.5 * std::sqrt(1 - std::pow(ispc.rest_length, 2));
        EXPECT_TRUE(ispc.rest_length < 0.35F || beside > 0.24) << "one leads through the cavity";
        onSkin += ball.restPosition(static_cast<int>(ispc.vertex)).norm() > 0.4;
    }
    EXPECT_GT(onSkin, 500);
}

TEST_F(HollowBodyTest, FallingHalvesKeepTheirVolume) {
    simulation.emplace(ball, test::weightless());
    const double volume = meshVolume(simulation->mesh());
    cut();
    ASSERT_EQ(simulation->pieces().pieces.size(), 2u);
    simulation->execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
    simulation->execute(SetParam{"floor", -0.55});
    run(150);
    double sum = 0;
    for (const Piece& piece : simulation->measuredPieces()) {
        EXPECT_NEAR(piece.volume, piece.restVolume, 0.01 * piece.restVolume);
        sum += piece.restVolume;
    }
    EXPECT_NEAR(sum, volume, 1e-5 * volume);
    EXPECT_EQ(checkClosedManifold(simulation->mesh()), "");
}

TEST_F(HollowBodyTest, WholeOneFallsAndKeepsItsCavity) {
    Params params;
    params.floor = -0.55;
    simulation.emplace(ball, params);
    run(150);
    const Piece piece = simulation->measuredPieces().at(0);
    EXPECT_NEAR(piece.volume, piece.restVolume, 0.01 * piece.restVolume);
}

}  // namespace
}  // namespace kerf
