#include "tests/support/reference/solver_pair.h"

#include <random>

#include "sim/body/rest_geometry.h"
#include "sim/body/solver_uniforms.h"

namespace kerf {

SolverPair::SolverPair(const SurfaceMesh& mesh, const Params& params, shared::uint parts,
                       unsigned seed, float shake)
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

double SolverPair::error() const {
    const std::vector<Vec3f> ours = gpu.readDisplacements();
    double largest = 0;
    for (std::size_t v = 0; v < ours.size(); ++v) {
        largest = std::max(largest, (ours[v].cast<double>() - reference.displacements[v]).norm());
    }
    return largest;
}

double SolverPair::positionError() const {
    const BodyState state = gpu.readState();
    double largest = 0;
    for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const Vec3 x = state.positions[v].cast<double>();
        largest = std::max(largest, (x - reference.positions[v]).norm());
    }
    return largest;
}

double SolverPair::change(const std::vector<Vec3>& before) const {
    double largest = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
        largest = std::max(largest, (reference.displacements[v] - before[v]).norm());
    }
    return largest;
}

}  // namespace kerf
