#include "sim/solve/implicit_stepper.h"

#include <gtest/gtest.h>

#include "gpu/context.h"
#include "sim/body/solver_uniforms.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/cut_ball.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/reference/implicit/implicit_solver.h"
#include "tests/support/variable.h"

namespace kerf {
namespace {

class ImplicitStepperTest : public test::GlTest {};

Params firm() {
    Params params;
    params.trueModulus = 1;
    params.youngsModulus = 1e5;
    params.floor.reset();
    return params;
}

/// A body in motion on both sides.
struct ImplicitPair {
    ImplicitPair(const BodyModel& body, const Params& params, const ImplicitStep& step,
                 const std::vector<std::uint32_t>& pinned)
        : model(body), settings(settingsOf(params, step)), solver(model, settings, pinned) {
        state = restState(model);
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            const Vec3 p = state.positions[v];
            state.velocities[v] =
                Vec3(0.7, 0.4, 0.2) + Vec3(3, 1, 0.5).cross(p) + Vec3(2 * p.y(), -p.z(), p.x());
        }
        for (const std::uint32_t v : pinned) {
            state.velocities[v].setZero();
        }
        BodyState start = stateOf(state);
        gpu.setModel(model, start);
        gpu.setUniforms(solverUniforms(params));
        gpu.masses().setPinned(pinned);
        gpu.implicitStepper().setBody(model, params, step, pinned);
    }
    static ImplicitSettings settingsOf(const Params& params, const ImplicitStep& step) {
        ImplicitSettings settings = implicitSettings(params);
        settings.step = step.step;
        settings.iterations = step.iterations;
        settings.aggregateSize = step.aggregateSize;
        return settings;
    }
    static BodyState stateOf(const ReferenceState& state) {
        BodyState out;
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            out.positions.push_back(state.positions[v].cast<float>());
            out.velocities.push_back(state.velocities[v].cast<float>());
        }
        return out;
    }
    /// Largest difference of positions [m].
    double error() const {
        const BodyState ours = gpu.readState();
        double largest = 0;
        for (std::size_t v = 0; v < ours.positions.size(); ++v) {
            const Vec3 x = ours.positions[v].cast<double>();
            largest = std::max(largest, (x - state.positions[v]).norm());
        }
        return largest;
    }

    BodyModel model;
    ImplicitSettings settings;
    ImplicitReference solver;
    ReferenceState state;
    GpuSolver gpu;
};

TEST_F(ImplicitStepperTest, StepsLikeTheReference) {
    for (const double height : {-0.03, -0.12}) {
        const BodyModel model = test::cutBallModel(height);
        for (const double pinnedBelow : {-1.0, -0.08}) {
            ImplicitPair pair(model, firm(), {}, test::verticesBelow(model, pinnedBelow));
            for (int i = 0; i < 4; ++i) {
                pair.solver.step(pair.state);
                pair.gpu.implicitStepper().run();
                EXPECT_LT(pair.error(), 1e-6) << "cut to " << height << ", step " << i;
            }
        }
    }
}

/// The state of a slit body after some steps.
BodyState stateAfterSteps(const Params& params) {
    ImplicitPair pair(test::cutBallModel(-0.03), params, {}, {});
    for (int i = 0; i < 6; ++i) {
        pair.gpu.implicitStepper().run();
    }
    return pair.gpu.readState();
}

TEST_F(ImplicitStepperTest, BothWaysOfKernelsGiveTheSameBits) {
    if (!gpu::queryDevice().software) {
        GTEST_SKIP() << "GPUs have too few images";
    }
    std::vector<BodyState> states;
    for (const std::string way : {"images", "shared"}) {
        const test::Variable kernels("KERF_KERNELS", way);
        states.push_back(stateAfterSteps(firm()));
    }
    EXPECT_EQ(states[0].positions, states[1].positions);
    EXPECT_EQ(states[0].velocities, states[1].velocities);
}

TEST_F(ImplicitStepperTest, StaysFiniteWithoutStiffness) {
    for (const char* name : {"stretch_stiffness", "bending_stiffness", "ispc_stiffness"}) {
        Params params = firm();
        ASSERT_EQ(setParam(params, name, 0.0), "");
        for (const Vec3f& p : stateAfterSteps(params).positions) {
            EXPECT_TRUE(p.allFinite()) << name;
        }
    }
}

}  // namespace
}  // namespace kerf
