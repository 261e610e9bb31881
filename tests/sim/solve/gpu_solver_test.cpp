#include "sim/solve/gpu_solver.h"

#include "sim/base/params.h"
#include "tests/support/reference/reference_constraints.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {
namespace {

/// A body, displaced from rest and in motion, on the GPU and in double precision, from the same
/// floats, to compare the two solvers.
struct SolverPair {
    /// `parts`: of SolverUniforms::active_parts. `shake`: how far from rest [edge lengths].
    /// Throws gpu::ShaderError, gpu::OutOfMemory.
    SolverPair(const SurfaceMesh& mesh, const Params& params, shared::uint parts, unsigned seed,
               float shake = 0.05f)
        : model(buildBodyModel(mesh)), uniforms(solverUniforms(params, model)) {
        uniforms.active_parts = parts;
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> noise(-1, 1);
        const auto vector = [&] { return Vec3f(noise(random), noise(random), noise(random)); };
        const float reach = shake * static_cast<float>(meanRestEdgeLength(mesh));
        for (const Vec3f& p : model.restPositions) {
            start.positions.push_back(p + reach * vector());
            start.velocities.push_back(vector());
        }
        reference = restState(model);
        for (std::size_t v = 0; v < start.positions.size(); ++v) {
            reference.positions[v] = start.positions[v].cast<double>();
            reference.velocities[v] = start.velocities[v].cast<double>();
        }
        gpu.setModel(model, start);
        gpu.setUniforms(uniforms);
    }

    /// Largest difference between the displacements of the two solvers [m].
    double error() const {
        const std::vector<Vec3f> ours = gpu.readDisplacements();
        double largest = 0;
        for (std::size_t v = 0; v < ours.size(); ++v) {
            largest =
                std::max(largest, (ours[v].cast<double>() - reference.displacements[v]).norm());
        }
        return largest;
    }
    /// Largest difference between their positions, between substeps [m].
    double positionError() const {
        const BodyState state = gpu.readState();
        double largest = 0;
        for (std::size_t v = 0; v < state.positions.size(); ++v) {
            const Vec3 x = state.positions[v].cast<double>();
            largest = std::max(largest, (x - reference.positions[v]).norm());
        }
        return largest;
    }
    /// Largest change of a displacement of the reference since `before` [m].
    double change(const std::vector<Vec3>& before) const {
        double largest = 0;
        for (std::size_t v = 0; v < before.size(); ++v) {
            largest = std::max(largest, (reference.displacements[v] - before[v]).norm());
        }
        return largest;
    }

    BodyModel model;
    shared::SolverUniforms uniforms;
    BodyState start;
    ReferenceState reference;
    GpuSolver gpu;
};

using shared::uint;

using Pair = SolverPair;

std::vector<SurfaceMesh> bodies() {
    return {icosphere(0), cubeSphere(8), torus(), bentTube()};
}

/// So brief that floats of displacements have many digits.
Params briefStep() {
    Params params = plainPbd();
    params.timeStep = 0.00025;
    return params;
}

class GpuSolverTest : public GlTest {
  protected:
    /// Runs predict, then one phase, on both. Expects them to agree within `tolerance` [m], and the
    /// phase to have done much more than that.
    template <class OnGpu, class OnReference>
    static void expectSamePhase(uint parts, double tolerance, OnGpu onGpu,
                                OnReference onReference) {
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
    Pair pair(cubeSphere(8), briefStep(), 0, 7);
    ReferenceSolver(pair.model, pair.uniforms).predict(pair.reference);
    pair.gpu.predictAndStretch();
    EXPECT_LT(pair.error(), kDisplacementTolerance);
}

TEST_F(GpuSolverTest, SolvesEdgesBendsAndIspcsLikeTheReference) {
    for (const auto& row : {std::pair{shared::kStretchPart, shared::kStretch},
                            {shared::kBendPart, shared::kBend},
                            {shared::kIspcPart, shared::kIspc}}) {
        const auto kind = row.second;
        SCOPED_TRACE(kind);
        expectSamePhase(
            row.first, kSweepTolerance,
            [&](GpuSolver& s) {
                if (kind != shared::kStretch) {  // which comes with the prediction
                    s.phases().solve(kind);
                }
            },
            [&](const ReferenceSolver& s, ReferenceState& state) { s.solve(kind, state); });
    }
}

TEST_F(GpuSolverTest, MeetsTheFloorLikeTheReference) {
    expectSamePhase(
        shared::kFloorPart, kPositionTolerance, [](GpuSolver& s) { s.phases().collideFloor(); },
        [](const ReferenceSolver& s, ReferenceState& state) { s.collideFloor(state); });
}

TEST_F(GpuSolverTest, FinishesLikeTheReference) {
    Pair pair(bentTube(), plainPbd(), 0, 7);
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
        Params params = plainPbd();
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
    const SurfaceMesh mesh =
        meshOf(joined(icosphereSoup(3), boxSoup({0.2, 0.3, 0.4}, 3), {2, 0, 0}));
    Pair pair(mesh, plainPbd(), 0, 3);
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
    Params params = plainPbd();
    params.floor = -3.0;
    Pair pair(icosphere(3), params, shared::kFloorPart, 3);
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
    Pair pair(cubeSphere(6), Params{}, solverUniforms(Params{}).active_parts, 3);
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
    Pair pair(icosphere(2), plainPbd(), 0, 3);
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
    Pair pair(icosphere(2), plainPbd(), 0, 3);
    pair.gpu.savedPieces().save();
    pair.gpu.step();
    EXPECT_NE(pair.gpu.readState().positions, pair.start.positions);
    pair.gpu.savedPieces().restoreAtRest(std::array{0});
    const BodyState state = pair.gpu.readState();
    EXPECT_EQ(state.positions, pair.start.positions);
    EXPECT_EQ(state.velocities, std::vector<Vec3f>(state.velocities.size(), Vec3f::Zero()));
}

TEST_F(GpuSolverTest, TakesLostPiecesBackAndLeavesTheOthersAlone) {
    const SurfaceMesh mesh =
        meshOf(joined(icosphereSoup(2), boxSoup({0.2, 0.3, 0.4}, 3), {2, 0, 0}));
    const auto run = [&](float badSpeed) {
        Pair pair(mesh, plainPbd(), solverUniforms(plainPbd()).active_parts, 3);
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
    Pair pair(cubeSphere(8), briefStep(), 0, 7);
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
    Params params = plainPbd();
    params.floor.reset();
    Pair pair(icosphere(2), params, solverUniforms(params).active_parts, 3);
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
        Pair pair(bentTube(), plainPbd(), solverUniforms(plainPbd()).active_parts, 13);
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
    Pair pair(icosphere(1), plainPbd(), solverUniforms(plainPbd()).active_parts, 1);
    const long before = pair.gpu.dispatches();
    pair.gpu.step();
    EXPECT_LE(pair.gpu.dispatches() - before, 6 * kUsualSweeps);
}

class SolverUpdateTest : public GlTest {
  protected:
    /// What one step of a blade changes that leaves the body at once.
    static CutDelta slashed(SurfaceMesh& mesh) {
        Cutter cutter(mesh, exactSettings());
        cutter.begin({{-2, 0.021, 0.013}, {2, 0.034, 0.055}});
        CutResult result = cutter.advance({{-2, 0.3, 1}, {2, 0.3, 1}});
        result = result.outcome == CutOutcome::cut ? result : cutter.finish();
        EXPECT_EQ(result.outcome, CutOutcome::cut);
        return result.delta;
    }
    /// A solver that follows the cuts, and one that is given the model whole, go on alike.
    void expectAlike(const BodyModel& model, const SurfaceMesh& mesh, GpuSolver& followed) {
        GpuSolver fresh;
        fresh.setModel(model, stateOf(mesh));
        const shared::SolverUniforms uniforms = solverUniforms(plainPbd(), model);
        fresh.setUniforms(uniforms);
        followed.setUniforms(uniforms);
        followed.setState(stateOf(mesh));
        const BodyMeasure a = followed.measure();
        const BodyMeasure b = fresh.measure();
        ASSERT_EQ(a.pieceVolumes.size(), b.pieceVolumes.size());
        for (std::size_t p = 0; p < a.pieceVolumes.size(); ++p) {
            EXPECT_NEAR(a.pieceVolumes[p], b.pieceVolumes[p], 1e-6);
        }
        EXPECT_EQ(a.bounds.low, b.bounds.low);
        EXPECT_EQ(a.bounds.high, b.bounds.high);
        for (GpuSolver* solver : {&followed, &fresh}) {
            solver->predictAndStretch();
            solver->phases().solve(shared::kBend);
            solver->phases().solve(shared::kIspc);
        }
        EXPECT_EQ(followed.readDisplacements(), fresh.readDisplacements());
    }
};

TEST_F(SolverUpdateTest, GoesOnLikeASolverThatIsGivenTheModelWhole) {
    SurfaceMesh mesh = icosphere(3);
    BodyUpdater body(mesh);
    GpuSolver solver;
    solver.setModel(body.model(), stateOf(mesh));
    int cuts = 0;
    std::size_t moved = 0;
    for (const Vec3& along : {Vec3(1, 0.05, 0.1), Vec3(0.1, -0.05, 1)}) {
        Cutter cutter(mesh, exactSettings());
        const Stroke stroke =
            straightStroke(Vec3(0.013, 0.021, 0.034), along.normalized(), -Vec3::UnitY(), 3, 2, 12);
        eachStep(cutter, stroke, [&](const CutResult& result) {
            if (!result.delta.empty()) {
                followCut(solver, body, mesh, result.delta);
                EXPECT_EQ(solver.readState().positions, stateOf(mesh).positions);
                expectAlike(body.model(), mesh, solver);
                moved += result.delta.movedVertices.size();
                ++cuts;
            }
        });
    }
    EXPECT_GT(cuts, 10);
    EXPECT_GT(moved, 0u) << "the clean-up did nothing";
    EXPECT_EQ(body.model().pieces.size(), 4u);
}

TEST_F(SolverUpdateTest, KeepsTheStateOfOldVertices) {
    SurfaceMesh mesh = icosphere(2);
    BodyUpdater body(mesh);
    GpuSolver solver;
    solver.setModel(body.model(), stateOf(mesh));
    solver.setUniforms(solverUniforms(Params{}, body.model()));
    solver.step();
    const BodyState before = solver.readState();
    const std::vector<std::uint32_t> written = followCut(solver, body, mesh, slashed(mesh));
    const BodyState given = stateOf(mesh);
    const BodyState after = solver.readState();
    ASSERT_EQ(after.positions.size(), static_cast<std::size_t>(mesh.vertexCount()));
    for (std::size_t v = 0; v < after.positions.size(); ++v) {
        const BodyState& expected =
            std::binary_search(written.begin(), written.end(), v) ? given : before;
        EXPECT_EQ(after.positions[v], expected.positions[v]);
        EXPECT_EQ(after.velocities[v], expected.velocities[v]);
    }
}

TEST_F(SolverUpdateTest, RemembersWhatACutAdded) {
    SurfaceMesh mesh = icosphere(2);
    BodyUpdater body(mesh);
    GpuSolver solver;
    solver.setModel(body.model(), stateOf(mesh));
    solver.setUniforms(solverUniforms(Params{}, body.model()));
    solver.savedPieces().save();
    followCut(solver, body, mesh, slashed(mesh));
    solver.step();
    std::vector<int> all(body.model().pieces.size());
    std::iota(all.begin(), all.end(), 0);
    solver.savedPieces().restoreAtRest(all);
    EXPECT_EQ(solver.readState().positions, stateOf(mesh).positions);
}

}  // namespace
}  // namespace kerf
