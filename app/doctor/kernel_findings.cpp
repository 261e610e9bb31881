#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/doctor/findings.h"
#include "app/doctor/recorded_answers.h"
#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "sim/body/solver_uniforms.h"
#include "sim/solve/gpu_solver.h"

namespace kerf::app {
namespace {

using shared::uint;

// Shares of the diagonal of the body. Floats at displacements of 4e-4 of it are 2e-11 apart, at
// positions 6e-8. Compilers that join products and sums differ by a few of those.
constexpr double kDisplacementError = 1e-9;
constexpr double kPositionError = 3e-7;
constexpr double kStepError = 5e-5;    // rounding grows over the substeps of a step
constexpr double kEnergyError = 1e-3;  // of the energy
constexpr double kFloorHeight = 0.6;   // of the body's: it lifts what is below

/// A builtin model, and what the reference makes of it.
struct Subject {
    const std::string& name;
    const SurfaceMesh& mesh;
    const RecordedAnswers& answers;
};

/// Takes the model at the recorded start. `parts`: of SolverUniforms::active_parts.
void begin(GpuSolver& gpu, const Subject& subject, const Params& params, uint parts) {
    const BodyModel model = buildBodyModel(subject.mesh);
    shared::SolverUniforms uniforms = solverUniforms(params, model);
    uniforms.active_parts = parts;
    gpu.setModel(model, subject.answers.start);
    gpu.setUniforms(uniforms);
}

/// One phase of a substep.
struct Phase {
    const char* name;
    uint parts;    ///< of SolverUniforms::active_parts
    double error;  ///< share of the diagonal
    std::function<void(GpuSolver&)> run;
};

Phase constraintPhase(const char* name, uint type, uint part) {
    return {name, part | shared::kPullAsBeforePart, kDisplacementError, [type](GpuSolver& gpu) {
                if (type != shared::kStretch) {  // edges are solved with the prediction
                    gpu.phases().solve(type);
                }
            }};
}

std::vector<Phase> phases() {
    return {constraintPhase("Edges", shared::kStretch, shared::kStretchPart),
            constraintPhase("Bends", shared::kBend, shared::kBendPart),
            constraintPhase("Inner constraints", shared::kIspc, shared::kIspcPart),
            {"Volume", shared::kVolumePart, kPositionError,
             [](GpuSolver& gpu) { gpu.phases().solveVolume(); }},
            {"Floor", shared::kFloorPart, kPositionError,
             [](GpuSolver& gpu) { gpu.phases().collideFloor(); }}};
}

/// How far vertices are from those of the reference. `share`: the largest allowed distance, of the
/// diagonal.
DriverFinding nearFinding(const std::string& check, const std::vector<Vec3f>& seen,
                          const Subject& subject, double share) {
    const std::vector<Vec3f>& right = subject.answers.vertices.at(check);
    double error = seen.size() == right.size() ? 0 : INFINITY;
    for (std::size_t v = 0; v < std::min(seen.size(), right.size()); ++v) {
        const double distance = (seen[v] - right[v]).cast<double>().norm();
        error = std::isnan(distance) ? INFINITY : std::max(error, distance);
    }
    const double most = share * meshBounds(subject.mesh).diagonal();
    return {check + ", " + subject.name, fmt::format("{:.1e} m from the reference", error),
            fmt::format("at most {:.1e} m", most), error <= most};
}

DriverFinding phaseFinding(const Phase& phase, const Subject& subject) {
    const Bounds bounds = meshBounds(subject.mesh);
    Params params;
    params.floor = bounds.low.y() + kFloorHeight * (bounds.high.y() - bounds.low.y());
    GpuSolver gpu;
    begin(gpu, subject, params, phase.parts);
    gpu.predictAndStretch();
    phase.run(gpu);
    return nearFinding(phase.name, gpu.readDisplacements(), subject, phase.error);
}

DriverFinding stepFinding(const char* name, SolverMode mode, const Subject& subject) {
    Params params;
    params.solver = mode;
    params.floor = meshBounds(subject.mesh).low.y();
    GpuSolver gpu;
    begin(gpu, subject, params, solverUniforms(params).active_parts);
    gpu.step();
    return nearFinding(name, gpu.readState().positions, subject, kStepError);
}

DriverFinding energyFinding(const Subject& subject) {
    GpuSolver gpu;
    begin(gpu, subject, Params{}, solverUniforms(Params{}).active_parts);
    const double expected = subject.answers.strainEnergy;
    const double error = std::abs(gpu.measure().strainEnergy - expected) / expected;
    return {"Strain energy, " + subject.name, fmt::format("{:.2e} of it off the reference", error),
            fmt::format("at most {:.0e}", kEnergyError), error <= kEnergyError};
}

}  // namespace

std::vector<DriverFinding> kernelFindings(const std::vector<std::string>& models) {
    const AnswersByModel answers = recordedAnswers();
    std::vector<DriverFinding> findings;
    for (const std::string& model : models) {
        const SurfaceMesh mesh = loadModel(builtinModelFile(model));
        const Subject subject{model, mesh, answers.at(model)};
        for (const Phase& phase : phases()) {
            findings.push_back(phaseFinding(phase, subject));
        }
        findings.push_back(stepFinding("A whole step", SolverMode::smallSteps, subject));
        findings.push_back(stepFinding("A whole step of PBD", SolverMode::pbd, subject));
        findings.push_back(energyFinding(subject));
    }
    return findings;
}

}  // namespace kerf::app
