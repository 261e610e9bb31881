#include <gtest/gtest.h>

#include <cmath>

#include "sim/body/solver_uniforms.h"
#include "tests/support/shapes.h"
#include "tests/support/small_steps.h"

namespace kerf {
namespace {

static_assert(sizeof(shared::SolverUniforms) % 16 == 0, "as GLSL rounds a record with a vec4 up");

TEST(SolverUniforms, IspcStiffnessRunsFromNoneOverTheMaterialToRigid) {
    EXPECT_EQ(ispcModulusFactor(0), 0);
    EXPECT_DOUBLE_EQ(ispcModulusFactor(0.5), 1);
    EXPECT_TRUE(std::isinf(ispcModulusFactor(1)));
    for (double s = 0.05; s <= 1; s += 0.05) {
        EXPECT_GT(ispcModulusFactor(s), ispcModulusFactor(s - 0.05)) << s;
    }
}

TEST(SolverUniforms, PartsWithoutStiffnessAreOff) {
    Params params = test::smallSteps();
    EXPECT_EQ(solverUniforms(params).active_parts,
              shared::kStretchPart | shared::kBendPart | shared::kIspcPart | shared::kVolumePart |
                  shared::kFloorPart | shared::kPullAsBeforePart | shared::kUnfoldPart);
    params.stretchStiffness = params.bendingStiffness = params.ispcStiffness = 0;
    params.floor.reset();
    EXPECT_EQ(solverUniforms(params).active_parts, shared::kPullAsBeforePart);
    params.solver = SolverMode::pbd;
    EXPECT_EQ(solverUniforms(params).active_parts, 0u);
}

TEST(SolverUniforms, MeanWhatTheyAreNamed) {
    Params params = test::smallSteps();
    params.timeStep = 0.01;
    params.iterations = 10;
    params.damping = 0.002;
    params.ispcStiffness = 1;
    const shared::SolverUniforms u = solverUniforms(params);
    EXPECT_FLOAT_EQ(u.substep, 0.001f);
    EXPECT_EQ(u.substeps, 10u);
    EXPECT_FLOAT_EQ(u.damping_ratio, 2);
    EXPECT_FLOAT_EQ(u.compliance[shared::kStretch], 10);  // 1 / (1e5 Pa * (1e-3 s)^2)
    EXPECT_EQ(u.compliance[shared::kIspc], 0);
    EXPECT_FLOAT_EQ(u.drag_factor, std::exp(-0.001));
    EXPECT_FLOAT_EQ(u.inverse_density, 0.001f);
}

// Each type alone is stable where its compliance has the room 1.
TEST(SolverUniforms, TypesShareTheRoomOfASweep) {
    Params params = test::smallSteps();
    params.trueModulus = 1;
    const shared::SolverUniforms u = solverUniforms(params);
    double shares = 0;
    for (const float room : u.sweep_room) {
        EXPECT_GT(room, 1);
        shares += 1 / room;
    }
    EXPECT_LT(shares, 1 + 1e-6);
}

TEST(SolverUniforms, PbdSpreadsItsStiffnessOverTheSweeps) {
    Params params = test::smallSteps();
    params.solver = SolverMode::pbd;
    params.iterations = 30;
    params.stretchStiffness = 2;
    const shared::SolverUniforms u = solverUniforms(params);
    EXPECT_FLOAT_EQ(u.substep, 0.005f);
    EXPECT_EQ(u.substeps, 1u);
    EXPECT_EQ(u.sweeps, 30u);
    EXPECT_EQ(u.share[shared::kStretch], 1) << "no more than rigid";
    EXPECT_EQ(u.compliance[shared::kStretch], 0);
    EXPECT_NEAR(std::pow(1 - u.share[shared::kIspc], 30), 1 - params.ispcStiffness, 1e-5);
    EXPECT_EQ(u.active_parts & shared::kVolumePart, 0u);
}

TEST(SolverUniforms, SweepStiffnessMeansTheSameForAnyNumberOfSweeps) {
    for (const double k : {0.0, 0.1, 0.5, 0.99, 1.0}) {
        for (const int n : {1, 5, 20, 80}) {
            EXPECT_NEAR(std::pow(1 - sweepStiffness(k, n), n), 1 - k, 1e-12) << k << " " << n;
        }
    }
}

TEST(SolverUniforms, CountTheModel) {
    const BodyModel model = buildBodyModel(test::icosphere(0));
    const shared::SolverUniforms u = solverUniforms(test::smallSteps(), model);
    EXPECT_EQ(u.vertex_count, 12u);
    EXPECT_EQ(u.count[shared::kStretch], 30u);
    EXPECT_EQ(u.count[shared::kBend], 30u);
    EXPECT_EQ(u.count[shared::kIspc], 12u);
    EXPECT_EQ(u.triangle_count, 20u);
    EXPECT_EQ(u.piece_count, 1u);
}

}  // namespace
}  // namespace kerf
