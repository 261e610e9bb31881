#include "tests/support/reference/reference_solver.h"

#include "tests/support/reference/reference_constraints.h"

namespace kerf {
namespace {

/// A body out of shape, in the middle of a substep: every coordinate of the positions is off by up
/// to `offset`, every one of the displacements is up to `displacement` [m].
ReferenceState shakenState(const BodyModel& model, unsigned seed, double offset,
                           double displacement) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    const auto vector = [&] {
        const double x = noise(random);
        const double y = noise(random);
        return Vec3(x, y, noise(random));
    };
    ReferenceState state = restState(model);
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        state.positions[v] += offset * vector();
        state.displacements[v] = displacement * vector();
    }
    return state;
}

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
    const BodyModel model = buildBodyModel(bentTube());
    const ReferenceSolver solver(model, solverUniforms(plainPbd(), model));
    for (std::uint32_t type = 0; type < kConstraintTypes; ++type) {
        const ReferenceState before = shakenState(model, 5, 0.01, 0.001);
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
    Params params = plainPbd();
    params.gravity = Vec3::Zero();
    params.floor.reset();
    params.airDrag = 0;
    return params;
}

TEST(ReferenceSolver, ABodyAtRestWithoutGravityStaysAtRest) {
    const BodyModel model = buildBodyModel(bentTube());
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
    const BodyModel model = buildBodyModel(icosphere(1));
    ReferenceSolver solver(model, solverUniforms(plainPbd(), model));
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
    const BodyModel model = buildBodyModel(icosphere(0));
    Params params = plainPbd();
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
    const SurfaceMesh pair = meshOf(joined(icosphereSoup(1), icosphereSoup(1), Vec3(3, 0, 0)));
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
    const BodyModel model = buildBodyModel(icosphere(0));
    const shared::SolverUniforms u = solverUniforms(Params{}, model);
    EXPECT_EQ(u.vertex_count, 12u);
    EXPECT_EQ(u.count[shared::kStretch], 30u);
    EXPECT_EQ(u.count[shared::kBend], 30u);
    EXPECT_EQ(u.count[shared::kIspc], 12u);
    EXPECT_EQ(u.triangle_count, 20u);
    EXPECT_EQ(u.piece_count, 1u);
}

/// The gradient of each constraint against central differences of its value.
template <class Constraint>
void expectGradients(const std::vector<Constraint>& constraints, const BodyModel& model) {
    const double step = 1e-6;
    const unsigned seed = 3;
    ReferenceState state = shakenState(model, seed, 0.02, 1e-9);
    for (const Constraint& constraint : constraints) {
        const auto exact = linearize(constraint, state);
        ASSERT_TRUE(exact.valid);
        if (std::abs(exact.value) >= shared::kMaxBendError) {
            continue;
        }
        for (std::size_t k = 0; k < exact.vertices.size(); ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                double& x = state.displacements[exact.vertices[k]][axis];
                const double x0 = x;
                x = x0 + step;
                const double forward = linearize(constraint, state).value;
                x = x0 - step;
                const double back = linearize(constraint, state).value;
                x = x0;
                EXPECT_NEAR(exact.gradient[k][axis], (forward - back) / (2 * step), 1e-6)
                    << "seed " << seed;
            }
        }
    }
}

TEST(ReferenceConstraints, GradientsAgreeWithFiniteDifferences) {
    const BodyModel model = buildBodyModel(icosphere(1));
    expectGradients(model.edges, model);
    expectGradients(model.bends, model);
    expectGradients(model.ispcs, model);
}

TEST(ReferenceConstraints, AreZeroAtRest) {
    const BodyModel model = buildBodyModel(bentTube());
    const ReferenceState rest = restState(model);
    for (const auto& c : model.edges) {
        EXPECT_NEAR(linearize(c, rest).value, 0, 1e-6);
    }
    for (const auto& c : model.bends) {
        EXPECT_NEAR(linearize(c, rest).value, 0, 1e-5);
    }
    for (const auto& c : model.ispcs) {
        EXPECT_NEAR(linearize(c, rest).value, 0, 1e-6);
    }
}

TEST(ReferenceConstraints, ABendIsClamped) {
    const BodyModel model = buildBodyModel(icosphere(1));
    ReferenceState state = restState(model);
    for (Vec3& p : state.positions) {
        p.y() *= 0.01;
    }
    double largest = 0;
    for (const auto& c : model.bends) {
        largest = std::max(largest, std::abs(linearize(c, state).value));
    }
    EXPECT_FLOAT_EQ(largest, shared::kMaxBendError);
}

TEST(ReferenceConstraints, PointsThatCoincideHaveNoGradient) {
    const BodyModel model = buildBodyModel(box());
    ReferenceState state = restState(model);
    std::ranges::fill(state.positions, Vec3(1, 2, 3));
    EXPECT_FALSE(linearize(model.edges[0], state).valid);
    EXPECT_FALSE(linearize(model.bends[0], state).valid);
    EXPECT_FALSE(linearize(model.ispcs[0], state).valid);
}

}  // namespace
}  // namespace kerf
