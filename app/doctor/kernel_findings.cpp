#include <spdlog/fmt/fmt.h>

#include <functional>

#include "app/doctor/findings.h"
#include "app/files/import/builtin_models.h"
#include "app/files/import/model_source.h"
#include "sim/body/solver_uniforms.h"
#include "sim/reference/reference_constraints.h"
#include "sim/reference/solver_pair.h"

namespace kerf::app {
namespace {

using shared::uint;

constexpr unsigned kSeed = 7;
// Shares of the diagonal of the body. Floats at displacements of 4e-4 of it are 2e-11 apart, at
// positions 6e-8. Compilers that join products and sums differ by a few of those.
constexpr double kDisplacementError = 1e-9;
constexpr double kPositionError = 3e-7;
constexpr double kStepError = 5e-5;    // rounding grows over the substeps of a step
constexpr double kEnergyError = 1e-3;  // of the energy
constexpr double kFloorHeight = 0.6;   // of the body's: it lifts what is below

/// One phase of a substep, by both solvers.
struct Phase {
    const char* name;
    uint parts;    ///< of SolverUniforms::active_parts
    double error;  ///< share of the diagonal
    std::function<void(GpuSolver&)> onGpu;
    std::function<void(const ReferenceSolver&, ReferenceState&)> onReference;
};

Phase constraintPhase(const char* name, uint type, uint part) {
    return {name, part | shared::kPullAsBeforePart, kDisplacementError,
            [type](GpuSolver& gpu) {
                if (type != shared::kStretch) {  // edges are solved with the prediction
                    gpu.phases().solve(type);
                }
            },
            [type](const ReferenceSolver& solver, ReferenceState& state) {
                solver.solve(type, state);
            }};
}

std::vector<Phase> phases() {
    return {constraintPhase("Edges", shared::kStretch, shared::kStretchPart),
            constraintPhase("Bends", shared::kBend, shared::kBendPart),
            constraintPhase("Inner constraints", shared::kIspc, shared::kIspcPart),
            {"Volume", shared::kVolumePart, kPositionError,
             [](GpuSolver& gpu) { gpu.phases().solveVolume(); },
             [](const ReferenceSolver& s, ReferenceState& state) { s.solveVolume(state); }},
            {"Floor", shared::kFloorPart, kPositionError,
             [](GpuSolver& gpu) { gpu.phases().collideFloor(); },
             [](const ReferenceSolver& s, ReferenceState& state) { s.collideFloor(state); }}};
}

DriverFinding nearFinding(const std::string& check, double error, double most) {
    return {check, fmt::format("{:.1e} m from the reference", error),
            fmt::format("at most {:.1e} m", most), error <= most};
}

DriverFinding phaseFinding(const Phase& phase, const std::string& model, const SurfaceMesh& mesh) {
    const Bounds bounds = meshBounds(mesh);
    Params params;
    params.floor = bounds.low.y() + kFloorHeight * (bounds.high.y() - bounds.low.y());
    SolverPair pair(mesh, params, phase.parts, kSeed);
    const ReferenceSolver solver(pair.model, pair.uniforms);
    solver.predict(pair.reference);
    pair.gpu.predictAndStretch();
    phase.onGpu(pair.gpu);
    phase.onReference(solver, pair.reference);
    return nearFinding(fmt::format("{}, {}", phase.name, model), pair.error(),
                       phase.error * bounds.diagonal());
}

DriverFinding stepFinding(SolverMode mode, const std::string& model, const SurfaceMesh& mesh) {
    Params params;
    params.solver = mode;
    params.floor = meshBounds(mesh).low.y();
    SolverPair pair(mesh, params, solverUniforms(params).active_parts, kSeed);
    ReferenceSolver(pair.model, pair.uniforms).step(pair.reference);
    pair.gpu.step();
    return nearFinding(
        fmt::format("A whole step{}, {}", mode == SolverMode::pbd ? " of PBD" : "", model),
        pair.positionError(), kStepError * meshBounds(mesh).diagonal());
}

DriverFinding energyFinding(const std::string& model, const SurfaceMesh& mesh) {
    SolverPair pair(mesh, Params{}, solverUniforms(Params{}).active_parts, kSeed);
    const double expected = strainEnergy(pair.model, pair.uniforms, pair.reference);
    const double seen = pair.gpu.measure().strainEnergy;
    const double error = std::abs(seen - expected) / expected;
    return {"Strain energy, " + model, fmt::format("{:.2e} of it off the reference", error),
            fmt::format("at most {:.0e}", kEnergyError), error <= kEnergyError};
}

}  // namespace

std::vector<DriverFinding> kernelFindings(const std::vector<std::string>& models) {
    std::vector<DriverFinding> findings;
    for (const std::string& model : models) {
        const SurfaceMesh mesh = loadModel(builtinModelFile(model));
        for (const Phase& phase : phases()) {
            findings.push_back(phaseFinding(phase, model, mesh));
        }
        findings.push_back(stepFinding(SolverMode::smallSteps, model, mesh));
        findings.push_back(stepFinding(SolverMode::pbd, model, mesh));
        findings.push_back(energyFinding(model, mesh));
    }
    return findings;
}

}  // namespace kerf::app
