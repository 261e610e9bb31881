#include "sim/solve/implicit_stepper.h"

#include "gpu/context.h"
#include "tests/support/reference/implicit/implicit_solver.h"
#include "tests/support/reference/implicit/surface_contacts.h"

namespace kerf {
namespace {

class ImplicitStepperTest : public GlTest {};

Params firm() {
    Params params;
    params.solver = SolverMode::implicit;
    params.timeStep = 1.0 / 240;
    params.youngsModulus = 1e5;
    params.floor.reset();
    params.contact = 0;
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
        shared::SolverUniforms uniforms = solverUniforms(params);
        uniforms.active_parts &= ~shared::kUnfoldPart;  // the reference does not unfold
        gpu.setUniforms(uniforms);
        gpu.masses().setPinned(pinned);
        ContactSettings contact = contactSettings(params);
        contact.edges = false;  // the reference does not know edges
        gpu.collisions().setSettings(contact);
        gpu.stepImplicitly(model, params, step, pinned);
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
        const BodyModel model = cutBallModel(height);
        for (const double pinnedBelow : {-1.0, -0.08}) {
            ImplicitPair pair(model, firm(), {}, verticesBelow(model, pinnedBelow));
            for (int i = 0; i < 4; ++i) {
                pair.solver.step(pair.state);
                pair.gpu.step();
                EXPECT_LT(pair.error(), 1e-6) << "cut to " << height << ", step " << i;
            }
        }
    }
}

// Aggregates of one patch each are so many that a level comes between them and the whole.
TEST_F(ImplicitStepperTest, StepsLikeTheReferenceWithRegions) {
    const BodyModel model = buildBodyModel(cutBall(-0.06, 16));
    const std::vector<ConstraintPull> pulls = pullsAtRest(model, typeModuli(firm()));
    ASSERT_TRUE(groupVertices(model, pulls, kPatchSize).hasLevelBetween());
    ImplicitPair pair(model, firm(), {1.0 / 240, 4, kPatchSize}, {});
    for (int i = 0; i < 4; ++i) {
        pair.solver.step(pair.state);
        pair.gpu.step();
        EXPECT_LT(pair.error(), 1e-6) << "step " << i;
    }
}

/// Halves of a ball that meet the floor and, with contact, each other.
struct FallingHalves {
    explicit FallingHalves(bool contact)
        : model(cutBallModel(-0.12)),
          params(onFloor(contact)),
          pair(model, params, {1.0 / 240, 8}, {}),
          surfaces(model, params.friction, params.floor, contact) {
        pair.solver.setContacts(&surfaces);
        for (std::size_t v = 0; v < pair.state.positions.size(); ++v) {
            const double towards = pair.state.positions[v].z() > 0.003 ? -0.3 : 0.3;
            pair.state.velocities[v] = Vec3(0.2, -0.7, towards);
        }
        pair.gpu.setState(ImplicitPair::stateOf(pair.state));
    }
    static Params onFloor(bool contact) {
        Params params = firm();
        params.contact = contact ? 1 : 0;
        params.floor = -0.102;
        return params;
    }
    void stepKernels() {
        pair.gpu.measure();  // for the search
        pair.gpu.step();
    }

    BodyModel model;
    Params params;
    ImplicitPair pair;
    SurfaceContacts surfaces;
};

// Of triangles that are equally near the kernels may take another one.
TEST_F(ImplicitStepperTest, TouchesLikeTheReference) {
    for (const bool contact : {false, true}) {
        FallingHalves halves(contact);
        int pushing = 0;
        for (int i = 0; i < 12; ++i) {
            halves.stepKernels();
            pushing = std::max(pushing, halves.pair.solver.step(halves.pair.state).pushing);
            EXPECT_LT(halves.pair.error(), contact ? 5e-4 : 2e-5) << "step " << i;
        }
        EXPECT_GT(pushing, contact ? 100 : 5);
    }
}

TEST_F(ImplicitStepperTest, BothWaysOfKernelsGiveTheSameBits) {
    if (!gpu::queryDevice().software) {
        GTEST_SKIP() << "GPUs have too few images";
    }
    std::vector<BodyState> states;
    for (const std::string way : {"images", "shared"}) {
        const Variable kernels("KERF_KERNELS", way);
        FallingHalves halves(true);
        for (int i = 0; i < 8; ++i) {
            halves.stepKernels();
        }
        states.push_back(halves.pair.gpu.readState());
    }
    EXPECT_EQ(states[0].positions, states[1].positions);
    EXPECT_EQ(states[0].velocities, states[1].velocities);
}

/// The state of a slit body after some steps.
BodyState stateAfterSteps(const Params& params) {
    ImplicitPair pair(cutBallModel(-0.03), params, {}, {});
    for (int i = 0; i < 6; ++i) {
        pair.gpu.step();
    }
    return pair.gpu.readState();
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
