#include "sim/body/solver_uniforms.h"
#include "sim/cut/cut_change.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/plain_pbd.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

class SolverUpdateTest : public test::GlTest {
  protected:
    /// A solver that follows the cuts, and one that is given the model whole, go on alike.
    void expectAlike(const BodyModel& model, const SurfaceMesh& mesh, GpuSolver& followed) {
        GpuSolver fresh;
        fresh.setModel(model, stateOf(mesh));
        const shared::SolverUniforms uniforms = solverUniforms(test::plainPbd(), model);
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
    SurfaceMesh mesh = test::icosphere(3);
    BodyUpdater body(mesh);
    GpuSolver solver;
    solver.setModel(body.model(), stateOf(mesh));
    int cuts = 0;
    std::size_t moved = 0;
    for (const Vec3& along : {Vec3(1, 0.05, 0.1), Vec3(0.1, -0.05, 1)}) {
        Cutter cutter(mesh, test::exactSettings());
        const test::Stroke stroke = test::straightStroke(
            Vec3(0.013, 0.021, 0.034), along.normalized(), -Vec3::UnitY(), 3, 2, 12);
        cutter.begin(stroke.front());
        for (std::size_t i = 1; i <= stroke.size(); ++i) {
            const CutResult result =
                i < stroke.size() ? cutter.advance(stroke[i]) : cutter.finish();
            if (!result.delta.empty()) {
                const BodyChange change = body.update(result.delta);
                const std::vector<std::uint32_t> written = rewrittenVertices(mesh, result.delta);
                solver.update(body.model(), change, written, stateOf(mesh, written));
                EXPECT_EQ(solver.readState().positions, stateOf(mesh).positions);
                expectAlike(body.model(), mesh, solver);
                moved += result.delta.movedVertices.size();
                ++cuts;
            }
        }
    }
    EXPECT_GT(cuts, 10);
    EXPECT_GT(moved, 0u) << "the clean-up did nothing";
    EXPECT_EQ(body.model().pieces.size(), 4u);
}

TEST_F(SolverUpdateTest, KeepsTheStateOfOldVertices) {
    SurfaceMesh mesh = test::icosphere(2);
    BodyUpdater body(mesh);
    GpuSolver solver;
    solver.setModel(body.model(), stateOf(mesh));
    solver.setUniforms(solverUniforms(Params{}, body.model()));
    solver.step();
    const BodyState before = solver.readState();
    Cutter cutter(mesh, test::exactSettings());
    cutter.begin({{-2, 0.021, 0.013}, {2, 0.034, 0.055}});
    const CutResult first = cutter.advance({{-2, 0.3, 1}, {2, 0.3, 1}});
    const CutResult result = first.outcome == CutOutcome::cut ? first : cutter.finish();
    ASSERT_EQ(result.outcome, CutOutcome::cut);
    const BodyChange change = body.update(result.delta);
    const std::vector<std::uint32_t> written = rewrittenVertices(mesh, result.delta);
    solver.update(body.model(), change, written, stateOf(mesh, written));
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
    SurfaceMesh mesh = test::icosphere(2);
    BodyUpdater body(mesh);
    GpuSolver solver;
    solver.setModel(body.model(), stateOf(mesh));
    solver.setUniforms(solverUniforms(Params{}, body.model()));
    solver.savedPieces().save();
    Cutter cutter(mesh, test::exactSettings());
    cutter.begin({{-2, 0.021, 0.013}, {2, 0.034, 0.055}});
    CutResult result = cutter.advance({{-2, 0.3, 1}, {2, 0.3, 1}});
    result = result.outcome == CutOutcome::cut ? result : cutter.finish();
    ASSERT_EQ(result.outcome, CutOutcome::cut);
    const BodyChange change = body.update(result.delta);
    const std::vector<std::uint32_t> written = rewrittenVertices(mesh, result.delta);
    solver.update(body.model(), change, written, stateOf(mesh, written));
    solver.step();
    std::vector<int> all(body.model().pieces.size());
    std::iota(all.begin(), all.end(), 0);
    solver.savedPieces().restoreAtRest(all);
    EXPECT_EQ(solver.readState().positions, stateOf(mesh).positions);
}

}  // namespace
}  // namespace kerf
