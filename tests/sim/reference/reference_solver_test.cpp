#include "tests/support/reference/reference_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sim/body/solver_uniforms.h"
#include "tests/support/shaken_state.h"
#include "tests/support/shape_error.h"
#include "tests/support/shapes.h"
#include "tests/support/small_steps.h"

namespace kerf {
namespace {

struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    double scale = 0;  ///< sum of the parts' sizes, to compare with
};

/// Of a displacement field `change` about the points where the substep began: what velocities
/// d / h carry on, since X + d is parallel to d but for X.
Momentum momentumOf(const ReferenceSolver& solver, const ReferenceState& before,
                    const std::vector<Vec3>& change) {
    Momentum momentum;
    for (std::size_t v = 0; v < change.size(); ++v) {
        const Vec3 part = change[v] / solver.inverseMass(static_cast<int>(v));
        momentum.linear += part;
        momentum.angular += before.positions[v].cross(part);
        momentum.scale += part.norm();
    }
    return momentum;
}

TEST(ReferenceSolver, EverySweepConservesMomentum) {
    const BodyModel model = buildBodyModel(test::bentTube());
    shared::SolverUniforms uniforms = solverUniforms(test::smallSteps(), model);
    uniforms.active_parts |= (1u << kConstraintTypes) - 1;
    const ReferenceSolver solver(model, uniforms);
    for (std::uint32_t type = 0; type <= kConstraintTypes; ++type) {
        const ReferenceState before = test::shakenState(model, 5, 0.01, 0.001);
        ReferenceState after = before;
        type < kConstraintTypes ? solver.solve(type, after) : solver.solveVolume(after);
        std::vector<Vec3> change;
        for (std::size_t v = 0; v < before.positions.size(); ++v) {
            change.push_back(after.displacements[v] - before.displacements[v]);
        }
        const Momentum momentum = momentumOf(solver, before, change);
        ASSERT_GT(momentum.scale, 0);
        EXPECT_LT(momentum.linear.norm(), 1e-12 * momentum.scale);
        EXPECT_LT(momentum.angular.norm(), 1e-12 * momentum.scale);
    }
}

Params freeFlight() {
    Params params = test::smallSteps();
    params.gravity = Vec3::Zero();
    params.floor.reset();
    params.airDrag = 0;
    return params;
}

TEST(ReferenceSolver, FreeFlightKeepsMomentumForFiveSeconds) {
    const BodyModel model = buildBodyModel(test::icosphere(1));
    const Params params = freeFlight();
    const ReferenceSolver solver(model, solverUniforms(params, model));
    ReferenceState state = test::shakenState(model, 9, 0.01, 0.001);
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
        state.velocities[v] = Vec3(1, 2, -0.5) + Vec3(0, 0.7, 0.2).cross(state.positions[v]);
    }
    const Momentum before = momentumOf(solver, state, state.velocities);
    for (int i = 0; i < 1000; ++i) {
        solver.step(state);
    }
    const Momentum after = momentumOf(solver, state, state.velocities);
    EXPECT_LT((after.linear - before.linear).norm(), 1e-11 * before.linear.norm());
    EXPECT_LT((after.angular - before.angular).norm(), 1e-9 * before.angular.norm());
}

TEST(ReferenceSolver, ABodyAtRestWithoutGravityStaysAtRest) {
    const BodyModel model = buildBodyModel(test::bentTube());
    const ReferenceSolver solver(model, solverUniforms(freeFlight(), model));
    ReferenceState state = restState(model);
    for (int i = 0; i < 50; ++i) {
        solver.step(state);
    }
    for (const Vec3& v : state.velocities) {
        EXPECT_LT(v.norm(), 1e-4);
    }
}

TEST(ReferenceSolver, KinematicVerticesGoOnWithTheirVelocity) {
    const BodyModel model = buildBodyModel(test::icosphere(1));
    ReferenceSolver solver(model, solverUniforms(test::smallSteps(), model));
    solver.setInverseMass(7, 0);
    ReferenceState state = restState(model);
    const Vec3 start = state.positions[7] += Vec3(0, 3, 0);
    state.velocities[7] = Vec3(0.1, 0, 0);
    for (int i = 0; i < 20; ++i) {
        solver.step(state);
    }
    EXPECT_LT((state.positions[7] - start - Vec3(0.01, 0, 0)).norm(), 1e-8);
}

TEST(ReferenceSolver, FrictionShortensTheSlideByAtMostItsShareOfTheLift) {
    const BodyModel model = buildBodyModel(test::icosphere(0));
    Params params = test::smallSteps();
    params.floor = -0.2;
    params.friction = 0.5;
    const ReferenceSolver solver(model, solverUniforms(params, model));
    ReferenceState state = restState(model);
    state.positions[0] = Vec3(0, -0.2, 0);
    state.displacements[0] = Vec3(0.3, -0.2, 0.4);
    state.positions[1] = Vec3(0, -0.2, 0);
    state.displacements[1] = Vec3(0.03, -0.2, 0.04);
    state.positions[2] = Vec3(0, 1, 0);
    state.displacements[2] = Vec3(0.03, -0.2, 0.04);
    solver.collideFloor(state);
    EXPECT_LT((state.displacements[0] - Vec3(0.24, 0, 0.32)).norm(), 1e-7);
    EXPECT_LT(state.displacements[1].norm(), 1e-7);
    EXPECT_EQ(state.displacements[2], Vec3(0.03, -0.2, 0.04));
}

TEST(ReferenceSolver, VolumeMovesToItsTarget) {
    const BodyModel model = buildBodyModel(test::icosphere(2));
    ReferenceSolver solver(model, solverUniforms(freeFlight(), model));
    const double target = 1.02 * model.pieces[0].restVolume;
    solver.setVolumeOffset(0, target - model.pieces[0].restVolume);
    ReferenceState state = restState(model);
    for (int i = 0; i < 3; ++i) {
        solver.solveVolume(state);
    }
    EXPECT_NEAR(solver.volumes(state)[0], target, 1e-6 * target);
}

struct DropResult {
    double meanVolume = 0;   ///< over rest
    double finalVolume = 0;  ///< over rest
    double peakError = 0;    ///< RMS shape error over the diagonal
    double finalSpeed = 0;   ///< of the fastest vertex [m/s]
    double lowest = 0;       ///< y of the lowest vertex at the end [m]
};

/// Drops a body from half a metre.
DropResult drop(const SurfaceMesh& mesh, const Params& params, int steps) {
    const BodyModel model = buildBodyModel(mesh);
    const ReferenceSolver solver(model, solverUniforms(params, model));
    ReferenceState state = restState(model);
    const std::vector<Vec3> rest = state.positions;
    std::vector<int> all(rest.size());
    std::iota(all.begin(), all.end(), 0);
    Bounds bounds;
    for (const Vec3& p : rest) {
        bounds.add(p);
    }
    for (Vec3& p : state.positions) {
        p.y() += 0.5 - bounds.low.y();
    }
    DropResult result;
    for (int i = 0; i < steps; ++i) {
        solver.step(state);
        result.finalVolume = solver.volumes(state)[0] / model.uncutRestVolume;
        result.meanVolume += result.finalVolume / steps;
        result.peakError =
            std::max(result.peakError, test::rmsShapeError(rest, state.positions, all));
    }
    result.peakError /= bounds.diagonal();
    result.lowest = 1e9;
    for (std::size_t v = 0; v < rest.size(); ++v) {
        result.lowest = std::min(result.lowest, state.positions[v].y());
        result.finalSpeed = std::max(result.finalSpeed, state.velocities[v].norm());
    }
    return result;
}

void expectSoftLanding(const DropResult& result) {
    EXPECT_TRUE(std::isfinite(result.finalSpeed));
    EXPECT_GT(result.meanVolume, 0.999);
    EXPECT_NEAR(result.finalVolume, 1, 1e-3);
    EXPECT_GT(result.peakError, 0.03);
    EXPECT_LT(result.peakError, 0.12);
    EXPECT_LT(result.finalSpeed, 0.3);
    EXPECT_NEAR(result.lowest, 0, 1e-3);
}

TEST(ReferenceSolver, DroppedSpheresKeepTheirVolumeLookSoftAndComeToRest) {
    const DropResult coarse = drop(test::icosphere(1), test::smallSteps(), 800);
    const DropResult fine = drop(test::cubeSphere(8), test::smallSteps(), 800);
    expectSoftLanding(coarse);
    expectSoftLanding(fine);
    // One Young's modulus behaves alike at every resolution.
    EXPECT_NEAR(coarse.peakError / fine.peakError, 1, 0.2);
}

TEST(ReferenceSolver, MoreIspcStiffnessMeansLessDeformation) {
    double last = 1;
    for (const double stiffness : {0.0, 0.25, 0.5, 1.0}) {
        Params params = test::smallSteps();
        params.ispcStiffness = stiffness;
        const DropResult result = drop(test::icosphere(1), params, 120);
        EXPECT_LT(result.peakError, 0.95 * last) << stiffness;
        last = result.peakError;
    }
}

TEST(ReferenceSolver, PiecesMoveIndependently) {
    const SurfaceMesh pair =
        test::meshOf(test::joined(test::icosphereSoup(1), test::icosphereSoup(1), Vec3(3, 0, 0)));
    const BodyModel model = buildBodyModel(pair);
    const ReferenceSolver solver(model, solverUniforms(freeFlight(), model));
    ReferenceState state = restState(model);
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
        state.velocities[v] = model.pieceOfVertex[v] == 0 ? Vec3(-1, 0, 0) : Vec3(1, 0, 0);
    }
    for (int i = 0; i < 100; ++i) {
        solver.step(state);
    }
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
        const double expected = model.pieceOfVertex[v] == 0 ? -1 : 1;
        EXPECT_NEAR(state.velocities[v].x(), expected, 1e-3);
    }
}

}  // namespace
}  // namespace kerf
