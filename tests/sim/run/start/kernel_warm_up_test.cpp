#include "sim/run/start/kernel_warm_up.h"

#include <gtest/gtest.h>

#include "gpu/program.h"
#include "sim/body/solver_uniforms.h"
#include "tests/support/gl_fixture.h"

namespace kerf {
namespace {

/// Whether a step of these parameters runs a kernel for the first time.
bool compilesInStep(const Params& params) {
    const SurfaceMesh mesh = touchingBoxes();
    const BodyModel model = buildBodyModel(mesh);
    GpuSolver solver;
    solver.setModel(model, approachingStateOf(mesh));
    solver.setUniforms(solverUniforms(params));
    solver.stepImplicitly(model, params, {}, {});
    const gpu::FirstDispatches none(0);
    solver.step();
    return none.foundAny();
}

class KernelWarmUpTest : public test::GlTest {};

TEST_F(KernelWarmUpTest, RunsTheKernelsOfImplicitStepsIfTheParametersHaveThem) {
    const gpu::ProgramShelf shelf;
    Params params;
    params.solver = SolverMode::implicit;
    KernelWarmUp warmUp(params);
    EXPECT_TRUE(compilesInStep(params));
    while (warmUp.advance()) {
    }
    EXPECT_FALSE(compilesInStep(params));
}

}  // namespace
}  // namespace kerf
