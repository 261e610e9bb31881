#include <gtest/gtest.h>

#include "sim/body/solver_uniforms.h"
#include "tests/support/shapes.h"

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
    Params params;
    EXPECT_EQ(solverUniforms(params).active_parts, shared::kStretchPart | shared::kBendPart |
                                                       shared::kIspcPart | shared::kVolumePart |
                                                       shared::kFloorPart | shared::kUnfoldPart);
    params.stretchStiffness = params.bendingStiffness = params.ispcStiffness = 0;
    params.floor.reset();
    EXPECT_EQ(solverUniforms(params).active_parts, 0u);
}

TEST(SolverUniforms, MeanWhatTheyAreNamed) {
    Params params;
    params.timeStep = 0.01;
    params.implicitSteps = 10;
    params.stretchStiffness = 2;
    params.ispcStiffness = 1;
    const shared::SolverUniforms u = solverUniforms(params);
    EXPECT_FLOAT_EQ(u.substep, 0.001f);
    EXPECT_EQ(u.substeps, 10u);
    EXPECT_EQ(u.sweeps, 0U);
    EXPECT_FLOAT_EQ(u.modulus[shared::kStretch], 2 * 0.35 * 1e5) << "their share of the load";
    EXPECT_FLOAT_EQ(u.modulus[shared::kBend], 1e5);
    EXPECT_EQ(u.modulus[shared::kIspc], 0) << "rigid, holds no energy";
    EXPECT_FLOAT_EQ(u.drag_factor, std::exp(-0.001));
    EXPECT_FLOAT_EQ(u.inverse_density, 0.001f);
}

TEST(SolverUniforms, PbdSpreadsItsStiffnessOverTheSweeps) {
    Params params;
    params.solver = SolverMode::pbd;
    params.iterations = 30;
    params.stretchStiffness = 2;
    const shared::SolverUniforms u = solverUniforms(params);
    EXPECT_FLOAT_EQ(u.substep, 0.005f);
    EXPECT_EQ(u.substeps, 1u);
    EXPECT_EQ(u.sweeps, 30u);
    EXPECT_EQ(u.share[shared::kStretch], 1) << "no more than rigid";
    EXPECT_EQ(u.modulus[shared::kStretch], 0);
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
    const shared::SolverUniforms u = solverUniforms(Params{}, model);
    EXPECT_EQ(u.vertex_count, 12u);
    EXPECT_EQ(u.count[shared::kStretch], 30u);
    EXPECT_EQ(u.count[shared::kBend], 30u);
    EXPECT_EQ(u.count[shared::kIspc], 12u);
    EXPECT_EQ(u.triangle_count, 20u);
    EXPECT_EQ(u.piece_count, 1u);
}

}  // namespace
}  // namespace kerf
