// What a person sees of the solver's parameters where a body falls.
#include <gtest/gtest.h>

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

// More vertices than one work group takes: its step goes by phases.
TEST_F(LargeDropTest, ABodyThatStepsByPhasesKeepsItsVolumeOnTheFloor) {
    test::DropScene scene;
    scene.height = 0.05;
    scene.seconds = 0.3;
    const test::DropFigures fallen = test::playDrop(test::cubeSphere(20), scene);
    EXPECT_GT(fallen.leastVolume, 0.999);
    EXPECT_GT(fallen.peakError, 0.01) << "it never met the floor";
    EXPECT_EQ(fallen.folds, 0);
}

INSTANTIATE_TEST_SUITE_P(BothModes, DropTest,
                         ::testing::Values(SolverMode::smallSteps, SolverMode::pbd),
                         [](const auto& each) {
                             return each.param == SolverMode::pbd ? "pbd" : "small_steps";
                         });

}  // namespace
}  // namespace kerf
