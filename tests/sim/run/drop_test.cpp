// What a person sees of the solver's parameters where a body falls.
#include <gtest/gtest.h>

#include "sim/run/simulation.h"
#include "tests/support/drop_scene.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

class DropTest : public test::GlTest, public ::testing::WithParamInterface<SolverMode> {
  protected:
    /// Half a small sphere, more precisely both of them, with the inside that `stiffness` makes.
    test::DropFigures dropHalves(double stiffness) {
        test::DropScene scene;
        scene.cut = true;
        scene.seconds = 1.4;  // before, halves still bounce in pbd
        scene.params.solver = GetParam();
        scene.params.iterations = 12;
        // In pbd, stiff bends alone hold a coarse skin up.
        scene.params.bendingStiffness = GetParam() == SolverMode::pbd ? 0.1 : 1;
        scene.params.ispcStiffness = stiffness;
        return test::playDrop(test::icosphere(1), scene);
    }
};

TEST_P(DropTest, HollowHalvesCollapseAndFirmOnesKeepTheirVolume) {
    const test::DropFigures hollow = dropHalves(0);
    const test::DropFigures soft = dropHalves(0.5);
    const test::DropFigures firm = dropHalves(1);
    EXPECT_EQ(hollow.pieces, 2);
    EXPECT_LT(hollow.finalVolume, 0.9) << "figure 2a of the paper";
    EXPECT_GT(soft.finalVolume, 0.97) << "figure 2b of the paper";
    EXPECT_GT(firm.finalVolume, 0.98);
    EXPECT_GT(hollow.peakError, 1.5 * soft.peakError);
    EXPECT_GT(soft.peakError, 1.2 * firm.peakError);
}

class LargeDropTest : public test::GlTest {};

TEST_F(LargeDropTest, KeepsItsVolumeOnTheFloor) {
    test::DropScene scene;
    scene.height = 0.05;
    scene.seconds = 0.3;
    const test::DropFigures fallen = test::playDrop(test::cubeSphere(20), scene);
    EXPECT_GT(fallen.leastVolume, 0.999);
    EXPECT_GT(fallen.peakError, 0.01) << "it never met the floor";
    // Skin that the floor presses flat in long steps turns over here and there until it rises.
    EXPECT_LE(fallen.folds, 12);
}

class RestTest : public test::GlTest {};

/// A material that is as soft as its modulus says.
struct SoftMaterial {
    double modulus = 0;  ///< [Pa]
    double damping = 0;  ///< [s]
    double friction = 0;
};

/// Both halves of a ball of 10 cm, cut askew, after 8 s on the floor [J].
double kineticEnergyOfHalves(const SoftMaterial& material) {
    Params params;
    const Vec3 middle(0, 0.055, 0);
    SurfaceMesh mesh = test::icosphere(1, 0.05);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + middle);
        mesh.setRestPosition(v, mesh.position(v));
    }
    params.youngsModulus = material.modulus;
    params.damping = material.damping;
    params.friction = material.friction;
    params.gravity.setZero();
    Simulation simulation(mesh, params);
    const Blade from{{0.030162, 0.026121, 0.098452}, {0.039865, 0.154187, 0.003032}};
    const Blade to{{-0.017967, -0.050063, -0.008691}, {-0.008264, 0.078003, -0.104111}};
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 40.0;
        simulation.execute(MoveBlade{{from.a + t * (to.a - from.a), from.b + t * (to.b - from.b)}});
        simulation.step();
    }
    simulation.execute(LiftBlade{});
    simulation.execute(SetParam{"gravity", Vec3(0, -9.81, 0)});
    while (simulation.report().time < 8) {
        simulation.step();
    }
    EXPECT_EQ(simulation.report().pieces, 2);
    return simulation.report().kineticEnergy;
}

// Liver, at whose small wall triangles constraints of all types want all that a sweep can carry.
TEST_F(RestTest, HalvesOfWhatIsSoftComeToRest) {
    EXPECT_LT(kineticEnergyOfHalves({5400, 0.0009, 0.3}), 3e-6) << "[J]";
}

// Brain: the weight of a half folds its rim.
TEST_F(RestTest, HalvesThatTheirWeightFoldsComeToRest) {
    EXPECT_LT(kineticEnergyOfHalves({1640, 0.0047, 0.2}), 3e-5) << "[J]";
}

INSTANTIATE_TEST_SUITE_P(BothModes, DropTest,
                         ::testing::Values(SolverMode::implicit, SolverMode::pbd),
                         [](const auto& each) {
                             return each.param == SolverMode::pbd ? "pbd" : "implicit";
                         });

}  // namespace
}  // namespace kerf
