#include "sim/solve/solver_uniforms.h"

#include <cmath>
#include <limits>

namespace kerf {

namespace {

using shared::uint;

// An absent part gets compliance 0; its bit in active_parts is off.
float complianceOverSquare(double modulus, double h) {
    return modulus > 0 ? static_cast<float>(1 / (modulus * h * h)) : 0.0f;
}

uint activeParts(const Params& params) {
    uint parts = 0;
    parts |= params.stretchStiffness > 0 ? shared::kStretchPart : 0u;
    parts |= params.bendingStiffness > 0 ? shared::kBendPart : 0u;
    parts |= params.ispcStiffness > 0 ? shared::kIspcPart : 0u;
    parts |= params.floor.has_value() ? shared::kFloorPart : 0u;
    return parts;
}

}  // namespace

double ispcModulusFactor(double stiffness) {
    if (stiffness >= 1) {
        return std::numeric_limits<double>::infinity();
    }
    const double odds = stiffness / (1 - stiffness);
    return odds * odds;
}

shared::SolverUniforms solverUniforms(const Params& params) {
    const double h = params.timeStep / params.iterations;
    const double modulus = params.youngsModulus;
    shared::SolverUniforms u{};
    u.gravity = {static_cast<float>(params.gravity.x()), static_cast<float>(params.gravity.y()),
                 static_cast<float>(params.gravity.z()), 0.0f};
    u.substep = static_cast<float>(h);
    u.drag_factor = static_cast<float>(std::exp(-params.airDrag * h));
    u.inverse_density = static_cast<float>(1 / params.density);
    u.damping_ratio = static_cast<float>(params.damping / h);
    u.stretch_compliance = complianceOverSquare(modulus * params.stretchStiffness, h);
    u.bend_compliance = complianceOverSquare(modulus * params.bendingStiffness, h);
    u.ispc_compliance = complianceOverSquare(modulus * ispcModulusFactor(params.ispcStiffness), h);
    u.friction = static_cast<float>(params.friction);
    u.floor_height = static_cast<float>(params.floor.value_or(0.0));
    u.active_parts = activeParts(params);
    u.substeps = static_cast<uint>(params.iterations);
    return u;
}

void setCounts(shared::SolverUniforms& uniforms, const BodyModel& model) {
    uniforms.vertex_count = static_cast<uint>(model.restPositions.size());
    uniforms.edge_count = static_cast<uint>(model.edges.size());
    uniforms.bend_count = static_cast<uint>(model.bends.size());
    uniforms.ispc_count = static_cast<uint>(model.ispcs.size());
    uniforms.triangle_count = static_cast<uint>(model.triangles.size());
    uniforms.piece_count = static_cast<uint>(model.pieces.size());
}

shared::SolverUniforms solverUniforms(const Params& params, const BodyModel& model) {
    shared::SolverUniforms u = solverUniforms(params);
    setCounts(u, model);
    return u;
}

}  // namespace kerf
