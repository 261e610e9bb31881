#include "sim/solve/gpu_solver.h"

#include "sim/body/solver_uniforms.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/plain_pbd.h"
#include "tests/support/reference/reference_constraints.h"
#include "tests/support/reference/solver_pair.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

using shared::uint;

using Pair = SolverPair;

std::vector<SurfaceMesh> bodies() {
    return {test::icosphere(0), test::cubeSphere(8), test::torus(), test::bentTube()};
}

/// So brief that floats of displacements have many digits.
Params briefStep() {
    Params params = test::plainPbd();
    params.timeStep = 0.00025;
    return params;
}

class GpuSolverTest : public test::GlTest {
  protected:
    /// Runs predict, then one phase, on both. Expects them to agree within `tolerance` [m], and the
    /// phase to have done much more than that.
    template <class OnGpu, class OnReference>
    void expectSamePhase(uint parts, double tolerance, OnGpu onGpu, OnReference onReference) {
        for (const SurfaceMesh& mesh : bodies()) {
            SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
            Params params = briefStep();
            params.floor = 0.2;  // some way up, so that it lifts part of each body
            Pair pair(mesh, params, parts, 7);
            const ReferenceSolver solver(pair.model, pair.uniforms);
            solver.predict(pair.reference);
            const std::vector<Vec3> before = pair.reference.displacements;
            pair.gpu.predictAndStretch();
            onGpu(pair.gpu);
            onReference(solver, pair.reference);
            EXPECT_LT(pair.error(), tolerance);
            EXPECT_GT(pair.change(before), 50 * tolerance);
        }
    }
};

// Displacements here are 4e-4 m, floats at that size 3e-11 m apart.
constexpr double kDisplacementTolerance = 2e-10;
// A sweep takes back the whole error of constraints, 0.01 to 0.1 m.
constexpr double kSweepTolerance = 1e-8;
// Positions are 0.5 m, floats at that size 6e-8 m apart.
constexpr double kPositionTolerance = 6e-8;

TEST_F(GpuSolverTest, PredictsLikeTheReference) {
    Pair pair(test::cubeSphere(8), briefStep(), 0, 7);
    ReferenceSolver(pair.model, pair.uniforms).predict(pair.reference);
    pair.gpu.predictAndStretch();
    EXPECT_LT(pair.error(), kDisplacementTolerance);
}

TEST_F(GpuSolverTest, SolvesEdgesLikeTheReference) {
    expectSamePhase(
        shared::kStretchPart, kSweepTolerance, [](GpuSolver&) {},
        [](const ReferenceSolver& s, ReferenceState& state) { s.solve(shared::kStretch, state); });
}

TEST_F(GpuSolverTest, SolvesBendsLikeTheReference) {
    expectSamePhase(
        shared::kBendPart, kSweepTolerance, [](GpuSolver& s) { s.phases().solve(shared::kBend); },
        [](const ReferenceSolver& s, ReferenceState& state) { s.solve(shared::kBend, state); });
}

TEST_F(GpuSolverTest, SolvesIspcsLikeTheReference) {
    expectSamePhase(
        shared::kIspcPart, kSweepTolerance, [](GpuSolver& s) { s.phases().solve(shared::kIspc); },
        [](const ReferenceSolver& s, ReferenceState& state) { s.solve(shared::kIspc, state); });
}

TEST_F(GpuSolverTest, MeetsTheFloorLikeTheReference) {
    expectSamePhase(
        shared::kFloorPart, kPositionTolerance, [](GpuSolver& s) { s.phases().collideFloor(); },
        [](const ReferenceSolver& s, ReferenceState& state) { s.collideFloor(state); });
}

TEST_F(GpuSolverTest, FinishesLikeTheReference) {
    Pair pair(test::bentTube(), test::plainPbd(), 0, 7);
    const ReferenceSolver solver(pair.model, pair.uniforms);
    solver.predict(pair.reference);
    solver.finish(pair.reference);
    pair.gpu.predictAndStretch();
    pair.gpu.phases().finish();
    const BodyState state = pair.gpu.readState();
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const Vec3 x = state.positions[v].cast<double>();
        const Vec3 u = state.velocities[v].cast<double>();
        EXPECT_LT((x - pair.reference.positions[v]).norm(), kPositionTolerance);
        EXPECT_LT((u - pair.reference.velocities[v]).norm(), 1e-6);
    }
}

TEST_F(GpuSolverTest, StepsLikeTheReference) {
    for (const SurfaceMesh& mesh : bodies()) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
        Params params = test::plainPbd();
        params.iterations = 7;
        params.floor = -0.45;
        Pair pair(mesh, params, solverUniforms(params).active_parts, 11);
        const ReferenceSolver solver(pair.model, pair.uniforms);
        solver.step(pair.reference);
        pair.gpu.step();
        EXPECT_LT(pair.positionError(), 1e-6);
        double moved = 0;
        for (std::size_t v = 0; v < pair.start.positions.size(); ++v) {
            const Vec3 start = pair.start.positions[v].cast<double>();
            moved = std::max(moved, (pair.reference.positions[v] - start).norm());
        }
        EXPECT_GT(moved, 1e-3);
    }
}

TEST_F(GpuSolverTest, MeasuresEveryPiece) {
    const SurfaceMesh mesh = test::meshOf(
        test::joined(test::icosphereSoup(3), test::boxSoup({0.2, 0.3, 0.4}, 3), {2, 0, 0}));
    Pair pair(mesh, test::plainPbd(), 0, 3);
    const std::vector<double> expected =
        ReferenceSolver(pair.model, pair.uniforms).volumes(pair.reference);
    const BodyMeasure measure = pair.gpu.measure();
    ASSERT_EQ(measure.pieceVolumes.size(), 2u);
    EXPECT_NEAR(measure.pieceVolumes[0], expected[0], 1e-6 * expected[0]);
    EXPECT_NEAR(measure.pieceVolumes[1], expected[1], 1e-6 * expected[1]);
    Bounds bounds;
    for (const Vec3& p : pair.reference.positions) {
        bounds.add(p);
    }
    EXPECT_EQ(measure.bounds.low, bounds.low);
    EXPECT_EQ(measure.bounds.high, bounds.high);
    EXPECT_TRUE(measure.lostPieces.empty());
}

TEST_F(GpuSolverTest, MeasuresTheEnergyOfAFallingBody) {
    Params params = test::plainPbd();
    params.floor = -3.0;
    Pair pair(test::icosphere(3), params, shared::kFloorPart, 3);
    const double mass = params.density * pair.model.pieces[0].restVolume;
    BodyState state{pair.model.restPositions, {}};
    state.velocities.assign(state.positions.size(), Vec3f(0, -2, 0));
    pair.gpu.setState(state);
    const BodyMeasure measure = pair.gpu.measure();
    EXPECT_NEAR(measure.kineticEnergy, 0.5 * mass * 4, 1e-3 * mass);
    // The middle of the sphere is 3 m above the floor.
    EXPECT_NEAR(measure.potentialEnergy, mass * 9.81 * 3, 1e-3 * mass * 9.81 * 3);
    ASSERT_EQ(measure.pieceBounds.size(), 1U);
    EXPECT_EQ(measure.pieceBounds[0].low, measure.bounds.low);
    const BodyMeasure again = pair.gpu.measure();
    EXPECT_EQ(again.kineticEnergy, measure.kineticEnergy);
    EXPECT_EQ(again.potentialEnergy, measure.potentialEnergy);
}

TEST_F(GpuSolverTest, MeasuresTheEnergyOfStrainedMaterialLikeTheReference) {
    for (const SurfaceMesh& mesh : bodies()) {
        SCOPED_TRACE(std::to_string(mesh.vertexCount()) + " vertices");
        for (const uint part : {shared::kStretchPart, shared::kBendPart, shared::kIspcPart,
                                solverUniforms(Params{}).active_parts}) {
            Pair pair(mesh, Params{}, part, 7);
            const double expected = strainEnergy(pair.model, pair.uniforms, pair.reference);
            EXPECT_GT(expected, 0);
            const double ours = pair.gpu.measure().strainEnergy;
            EXPECT_NEAR(ours, expected, 1e-4 * expected) << part;
            EXPECT_EQ(pair.gpu.measure().strainEnergy, ours);
        }
    }
}

// Edges and ISPCs are springs of their own length, and angles stay.
TEST_F(GpuSolverTest, StrainEnergyGrowsWithTheSquareOfAStretch) {
    Pair pair(test::cubeSphere(6), Params{}, solverUniforms(Params{}).active_parts, 3);
    const auto energyAt = [&](float strain) {
        BodyState state = pair.start;
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            state.positions[v] = (1 + strain) * pair.model.restPositions[v];
        }
        pair.gpu.setState(state);
        return pair.gpu.measure().strainEnergy;
    };
    const double energy = energyAt(0.05f);
    EXPECT_NEAR(energyAt(0.1f), 4 * energy, 1e-3 * energy);
    EXPECT_NEAR(energyAt(-0.05f), energy, 1e-3 * energy);
    EXPECT_LT(energyAt(0), 1e-6 * energy);
}

TEST_F(GpuSolverTest, FlagsWhatIsNotFiniteOrRunsAway) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    Pair pair(test::icosphere(2), test::plainPbd(), 0, 3);
    const BodyState good = pair.start;
    for (const float bad : {nan, infinite, -infinite, 1e30f, 1e4f}) {
        BodyState state = good;
        state.positions.back().y() = bad;
        pair.gpu.setState(state);
        EXPECT_FALSE(pair.gpu.measure().lostPieces.empty()) << "position " << bad;
        state = good;
        state.velocities.front().z() = bad;
        pair.gpu.setState(state);
        EXPECT_FALSE(pair.gpu.measure().lostPieces.empty()) << "velocity " << bad;
    }
    pair.gpu.setState(good);
    EXPECT_TRUE(pair.gpu.measure().lostPieces.empty());
}

TEST_F(GpuSolverTest, RestoresTheSavedStateAtRest) {
    Pair pair(test::icosphere(2), test::plainPbd(), 0, 3);
    pair.gpu.savedPieces().save();
    pair.gpu.step();
    EXPECT_NE(pair.gpu.readState().positions, pair.start.positions);
    pair.gpu.savedPieces().restoreAtRest(std::array{0});
    const BodyState state = pair.gpu.readState();
    EXPECT_EQ(state.positions, pair.start.positions);
    EXPECT_EQ(state.velocities, std::vector<Vec3f>(state.velocities.size(), Vec3f::Zero()));
}

TEST_F(GpuSolverTest, TakesLostPiecesBackAndLeavesTheOthersAlone) {
    const SurfaceMesh mesh = test::meshOf(
        test::joined(test::icosphereSoup(2), test::boxSoup({0.2, 0.3, 0.4}, 3), {2, 0, 0}));
    const auto run = [&](float badSpeed) {
        Pair pair(mesh, test::plainPbd(), solverUniforms(test::plainPbd()).active_parts, 3);
        BodyState state = pair.start;
        state.velocities.front().x() += badSpeed;
        pair.gpu.setState(state);
        pair.gpu.savedPieces().save();
        pair.gpu.step();
        const std::vector<int> lost = pair.gpu.measure().lostPieces;
        pair.gpu.savedPieces().restoreAtRest(lost);
        return std::tuple(lost, pair.start, pair.gpu.readState(), pair.model.pieceOfVertex);
    };
    const auto [none, start, expected, ignored] = run(0);
    EXPECT_TRUE(none.empty());
    const auto [lost, begin, after, pieceOf] = run(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(lost, std::vector<int>{0});
    for (std::size_t v = 0; v < after.positions.size(); ++v) {
        const bool isLost = pieceOf[v] == 0;
        EXPECT_EQ(after.positions[v], isLost ? begin.positions[v] : expected.positions[v]);
        EXPECT_EQ(after.velocities[v], isLost ? Vec3f::Zero() : expected.velocities[v]);
    }
}

TEST_F(GpuSolverTest, PullsLikeTheReference) {
    Pair pair(test::cubeSphere(8), briefStep(), 0, 7);
    std::vector<shared::PullRecord> pulls;
    for (uint v = 3; v < 40; v += 2) {
        pulls.push_back({v, 0.1f, 0.7f, 0.2f, 1.0f, 0.0f, -2.0f, v % 4 == 1 ? 1u : 0u});
    }
    ReferenceSolver solver(pair.model, pair.uniforms);
    solver.setPulls(pulls);
    solver.predict(pair.reference);
    const std::vector<Vec3> before = pair.reference.displacements;
    solver.pull(pair.reference);
    pair.gpu.setPulls(pulls);
    pair.gpu.predictAndStretch();
    pair.gpu.phases().pull();
    EXPECT_LT(pair.error(), 1e-9);
    EXPECT_GT(pair.change(before), 1e-4);
    EXPECT_EQ(pair.reference.displacements[4], before[4]);
}

TEST_F(GpuSolverTest, PinnedVerticesStayAndAreFreedAgain) {
    Params params = test::plainPbd();
    params.floor.reset();
    Pair pair(test::icosphere(2), params, solverUniforms(params).active_parts, 3);
    pair.gpu.masses().setPinned({2, 7, 50});
    for (int step = 0; step < 5; ++step) {
        pair.gpu.step();
    }
    const BodyState held = pair.gpu.readState();
    for (const int v : {2, 7, 50}) {
        EXPECT_EQ(held.positions[v], pair.start.positions[v]);
    }
    EXPECT_NE(held.positions[3], pair.start.positions[3]);
    pair.gpu.masses().setPinned({7});
    pair.gpu.step();
    const BodyState freed = pair.gpu.readState();
    EXPECT_NE(freed.positions[2], held.positions[2]);
    EXPECT_EQ(freed.positions[7], held.positions[7]);
}

TEST_F(GpuSolverTest, RunsTwiceToTheSameBits) {
    const auto run = [] {
        Pair pair(test::bentTube(), test::plainPbd(), solverUniforms(test::plainPbd()).active_parts,
                  13);
        for (int step = 0; step < 20; ++step) {
            pair.gpu.step();
        }
        return pair.gpu.readState();
    };
    const BodyState first = run();
    const BodyState second = run();
    EXPECT_EQ(first.positions, second.positions);
    EXPECT_EQ(first.velocities, second.velocities);
}

TEST_F(GpuSolverTest, UsesAtMostSixDispatchesASweep) {
    Pair pair(test::icosphere(1), test::plainPbd(), solverUniforms(test::plainPbd()).active_parts,
              1);
    const long before = pair.gpu.dispatches();
    pair.gpu.step();
    EXPECT_LE(pair.gpu.dispatches() - before, 6 * kUsualSweeps);
}

}  // namespace
}  // namespace kerf
