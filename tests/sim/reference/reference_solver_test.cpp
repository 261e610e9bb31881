#include "tests/support/reference/reference_solver.h"

#include <gtest/gtest.h>

#include "sim/body/solver_uniforms.h"
#include "tests/support/plain_pbd.h"
#include "tests/support/shaken_state.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

struct Momentum {
    Vec3 linear = Vec3::Zero();
    Vec3 angular = Vec3::Zero();
    double scale = 0;  ///< sum of the parts' sizes, to compare with
};

/// Of a displacement field `change` about the points from which it was made.
Momentum momentumOf(const ReferenceSolver& solver, const ReferenceState& before,
                    const std::vector<Vec3>& change) {
    Momentum momentum;
    for (std::size_t v = 0; v < change.size(); ++v) {
        const Vec3 part = change[v] / solver.inverseMass(static_cast<int>(v));
        momentum.linear += part;
        momentum.angular += (before.positions[v] + before.displacements[v]).cross(part);
        momentum.scale += part.norm();
    }
    return momentum;
}

TEST(ReferenceSolver, EverySweepConservesMomentum) {
    const BodyModel model = buildBodyModel(test::bentTube());
    const ReferenceSolver solver(model, solverUniforms(test::plainPbd(), model));
    for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
        const ReferenceState before = test::shakenState(model, 5, 0.01, 0.001);
        ReferenceState after = before;
        solver.solve(type, after);
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
    Params params = test::plainPbd();
    params.gravity = Vec3::Zero();
    params.floor.reset();
    params.airDrag = 0;
    return params;
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
    ReferenceSolver solver(model, solverUniforms(test::plainPbd(), model));
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
    Params params = test::plainPbd();
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
