// The answers that kerf doctor compares a driver with are those of the reference solver. KERF_RENEW
// writes them anew.
#include "app/doctor/recorded_answers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iterator>

#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "sim/base/byte_archive.h"
#include "sim/body/solver_uniforms.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/reference/reference_constraints.h"
#include "tests/support/reference/solver_pair.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using shared::uint;

constexpr unsigned kSeed = 7;

class RecordedAnswersTest : public test::GlTest {};

struct Phase {
    const char* name;
    uint parts;
    std::function<void(const ReferenceSolver&, ReferenceState&)> run;
};

Phase constraintPhase(const char* name, uint type, uint part) {
    return {name, part | shared::kPullAsBeforePart,
            [type](const ReferenceSolver& solver, ReferenceState& state) {
                solver.solve(type, state);
            }};
}

std::vector<Phase> phases() {
    return {constraintPhase("Edges", shared::kStretch, shared::kStretchPart),
            constraintPhase("Bends", shared::kBend, shared::kBendPart),
            constraintPhase("Inner constraints", shared::kIspc, shared::kIspcPart),
            {"Volume", shared::kVolumePart,
             [](const ReferenceSolver& s, ReferenceState& state) { s.solveVolume(state); }},
            {"Floor", shared::kFloorPart,
             [](const ReferenceSolver& s, ReferenceState& state) { s.collideFloor(state); }}};
}

std::vector<Vec3f> rounded(const std::vector<Vec3>& vertices) {
    std::vector<Vec3f> floats;
    std::ranges::transform(vertices, std::back_inserter(floats),
                           [](const Vec3& v) { return Vec3f(v.cast<float>()); });
    return floats;
}

std::vector<Vec3f> afterPhase(const Phase& phase, const SurfaceMesh& mesh) {
    const Bounds bounds = meshBounds(mesh);
    Params params;
    params.floor = bounds.low.y() + 0.6 * (bounds.high.y() - bounds.low.y());
    SolverPair pair(mesh, params, phase.parts, kSeed);
    const ReferenceSolver solver(pair.model, pair.uniforms);
    solver.predict(pair.reference);
    phase.run(solver, pair.reference);
    return rounded(pair.reference.displacements);
}

std::vector<Vec3f> afterStep(SolverMode mode, const SurfaceMesh& mesh) {
    Params params;
    params.solver = mode;
    params.floor = meshBounds(mesh).low.y();
    SolverPair pair(mesh, params, solverUniforms(params).active_parts, kSeed);
    ReferenceSolver(pair.model, pair.uniforms).step(pair.reference);
    return rounded(pair.reference.positions);
}

RecordedAnswers answersFor(const std::string& model) {
    const SurfaceMesh mesh = loadModel(builtinModelFile(model));
    const SolverPair pair(mesh, Params{}, solverUniforms(Params{}).active_parts, kSeed);
    RecordedAnswers answers{pair.start, {}, 0};
    for (const Phase& phase : phases()) {
        answers.vertices[phase.name] = afterPhase(phase, mesh);
    }
    answers.vertices["A whole step"] = afterStep(SolverMode::smallSteps, mesh);
    answers.vertices["A whole step of PBD"] = afterStep(SolverMode::pbd, mesh);
    answers.strainEnergy = strainEnergy(pair.model, pair.uniforms, pair.reference);
    return answers;
}

void expectSame(const RecordedAnswers& recorded, const RecordedAnswers& now) {
    constexpr float kRounding = 2e-7F;  // of a vertex: a compiler may round it otherwise
    EXPECT_EQ(recorded.start.positions, now.start.positions);
    EXPECT_EQ(recorded.start.velocities, now.start.velocities);
    EXPECT_NEAR(recorded.strainEnergy, now.strainEnergy, 1e-9 * now.strainEnergy);
    ASSERT_EQ(recorded.vertices.size(), now.vertices.size());
    for (const auto& [check, vertices] : now.vertices) {
        const std::vector<Vec3f>& before = recorded.vertices.at(check);
        ASSERT_EQ(before.size(), vertices.size()) << check;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            ASSERT_LE((vertices[v] - before[v]).norm(), kRounding * vertices[v].norm())
                << check << ", vertex " << v;
        }
    }
}

TEST_F(RecordedAnswersTest, AreThoseOfTheReference) {
    AnswersByModel now;
    for (const char* model : {"sphere20", "sphere768", "banana"}) {
        now.emplace(model, answersFor(model));
    }
    if (std::getenv("KERF_RENEW") != nullptr) {
        ByteWriter to;
        to(now);
        test::writeText(recordedAnswersFile(),
                        {reinterpret_cast<const char*>(to.bytes.data()), to.bytes.size()});
    }
    const AnswersByModel recorded = recordedAnswers();
    ASSERT_EQ(recorded.size(), now.size());
    for (const auto& [model, answers] : now) {
        SCOPED_TRACE(model);
        expectSame(recorded.at(model), answers);
    }
}

}  // namespace
}  // namespace kerf::app
