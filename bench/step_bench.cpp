// Milliseconds of one time step of the builtin models with plain PBD: the GPU solver without
// contact beside the reference solver (double precision, one thread), and with contact.

#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "bench/timing.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "sim/body/solver_uniforms.h"
#include "sim/solve/gpu_solver.h"
#include "tests/support/plain_pbd.h"
#include "tests/support/reference/reference_solver.h"

namespace kerf {
namespace {

constexpr int kRepeats = 15;

BodyState atRest(const BodyModel& model) {
    return {model.restPositions, std::vector<Vec3f>(model.restPositions.size(), Vec3f::Zero())};
}

double gpuStep(const BodyModel& model, const shared::SolverUniforms& uniforms,
               const ContactSettings& contact) {
    GpuSolver solver;
    solver.setModel(model, atRest(model));
    solver.setUniforms(uniforms);
    solver.collisions().setSettings(contact);
    return medianMilliseconds(kRepeats, [&] {
        solver.step();
        solver.measure();  // waits for the GPU
    });
}

double referenceStep(const BodyModel& model, const shared::SolverUniforms& uniforms) {
    const ReferenceSolver solver(model, uniforms);
    ReferenceState state = restState(model);
    return medianMilliseconds(kRepeats, [&] { solver.step(state); });
}

void benchModel(const std::string& name) {
    const BodyModel model = buildBodyModel(app::loadModel(app::builtinModelFile(name)));
    const shared::SolverUniforms uniforms = solverUniforms(test::plainPbd(), model);
    const double ours = gpuStep(model, uniforms, {});
    Params touching = test::plainPbd();
    touching.contact = 1;
    const double withContact = gpuStep(model, uniforms, contactSettings(touching));
    const double theirs = referenceStep(model, uniforms);
    const nlohmann::ordered_json line = {
        {"name", "step/" + name}, {"ours", ours},
        {"theirs", theirs},       {"peer", "reference solver, double, one thread"},
        {"ratio", theirs / ours}, {"unit", "ms"}};
    std::puts(line.dump().c_str());
    const nlohmann::ordered_json contactLine = {
        {"name", "step with contact/" + name},     {"ours", withContact},         {"theirs", ours},
        {"peer", "the same step without contact"}, {"ratio", ours / withContact}, {"unit", "ms"}};
    std::puts(contactLine.dump().c_str());
}

}  // namespace
}  // namespace kerf

int main() {
    try {
        const kerf::gpu::EglContext context;
        for (const std::string& name : kerf::app::builtinModels()) {
            kerf::benchModel(name);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
