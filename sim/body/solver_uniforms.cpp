#include "sim/body/solver_uniforms.h"

namespace kerf {

namespace {

using shared::uint;

/// Of a type of constraints; one without a parameter is off.
double stiffnessOf(uint type, const Params& params) {
    switch (type) {
        case shared::kStretch:
            return params.stretchStiffness;
        case shared::kBend:
            return params.bendingStiffness;
        case shared::kIspc:
            return params.ispcStiffness;
        default:
            return 0;
    }
}

// What is hollow or limp may fold.
bool unfolds(const Params& params) {
    return holdsVolume(params) && params.bendingStiffness > 0;
}

uint activeParts(const Params& params) {
    uint parts = 0;
    for (uint type = 0; type < kConstraintTypes; ++type) {
        parts |= stiffnessOf(type, params) > 0 ? 1u << type : 0u;
    }
    parts |= holdsVolume(params) ? shared::kVolumePart : 0u;
    parts |= unfolds(params) ? shared::kUnfoldPart : 0u;
    parts |= params.floor.has_value() ? shared::kFloorPart : 0u;
    return parts;
}

/// See modulusFactor().
double modulusShare(uint type) {
    // Skin and ISPCs that each carried the whole load would make a body twice as stiff. These come
    // from docs/notes/effective-modulus.md: the pair with which bars, slabs and blocks at rest are
    // nearest to a solid.
    constexpr double kSkin = 0.35;
    constexpr double kInside = 1.75;
    if (type == shared::kBend) {
        return 1;
    }
    return type == shared::kStretch ? kSkin : kInside;
}

}  // namespace

double modulusFactor(uint type, const Params& params) {
    const double stiffness = stiffnessOf(type, params);
    const double factor = type == shared::kIspc ? ispcModulusFactor(stiffness) : stiffness;
    return factor * modulusShare(type);
}

IspcRays ispcRays(const Params& params) {
    return params.solver == SolverMode::pbd ? IspcRays::alongNormal : IspcRays::turned;
}

bool holdsVolume(const Params& params) {
    return params.solver != SolverMode::pbd && params.ispcStiffness > 0;
}

bool keepsShape(const Params& params) {
    return std::min({params.stretchStiffness, params.bendingStiffness, params.ispcStiffness}) > 0;
}

double ispcModulusFactor(double stiffness) {
    if (stiffness >= 1) {
        return std::numeric_limits<double>::infinity();
    }
    const double odds = stiffness / (1 - stiffness);
    return odds * odds;
}

double sweepStiffness(double stiffness, int sweeps) {
    return 1 - std::pow(1 - std::clamp(stiffness, 0.0, 1.0), 1.0 / sweeps);
}

double catchUpSpeed(const Params& params) {
    constexpr double kLeast = 1;
    constexpr double kOfWave = 0.1;  // that runs along a bar
    return std::max(kLeast, kOfWave * std::sqrt(params.youngsModulus / params.density));
}

double stageOf(double step) {
    return (1 - std::sqrt(0.5)) * step;  // shared::kStageShare
}

double firmestIn(double step) {
    const double stage = stageOf(step);
    return shared::kMostFirmness / (stage * stage);
}

namespace {

/// What both modes share, for a step h [s].
shared::SolverUniforms commonUniforms(const Params& params, double h) {
    shared::SolverUniforms u{};
    u.gravity = {static_cast<float>(params.gravity.x()), static_cast<float>(params.gravity.y()),
                 static_cast<float>(params.gravity.z()), 0.0f};
    u.substep = static_cast<float>(h);
    u.drag_factor = static_cast<float>(std::exp(-params.airDrag * h));
    u.inverse_density = static_cast<float>(1 / params.density);
    u.friction = static_cast<float>(params.friction);
    u.lift_speed = static_cast<float>(params.depenetrationSpeed);
    u.floor_height = static_cast<float>(params.floor.value_or(0.0));
    u.catch_up_speed = static_cast<float>(catchUpSpeed(params));
    u.active_parts = activeParts(params);
    return u;
}

shared::SolverUniforms implicitUniforms(const Params& params) {
    shared::SolverUniforms u = commonUniforms(params, params.timeStep / params.implicitSteps);
    u.substeps = static_cast<uint>(params.implicitSteps);
    for (uint type = 0; type < kConstraintTypes; ++type) {
        const double modulus = params.youngsModulus * modulusFactor(type, params);
        u.modulus[type] = std::isfinite(modulus) ? static_cast<float>(modulus) : 0.0F;
    }
    return u;
}

/// Rigid constraints, of whose corrections each sweep applies a share.
shared::SolverUniforms pbdUniforms(const Params& params) {
    shared::SolverUniforms u = commonUniforms(params, params.timeStep);
    u.substeps = 1;
    const int sweeps = numberOfIterations(params);
    u.sweeps = static_cast<uint>(sweeps);
    for (uint type = 0; type < kConstraintTypes; ++type) {
        u.share[type] = static_cast<float>(sweepStiffness(stiffnessOf(type, params), sweeps));
    }
    return u;
}

}  // namespace

int numberOfIterations(const Params& params) {
    constexpr int kOfImplicitStage = 8;
    const int usual = params.solver == SolverMode::pbd ? kUsualSweeps : kOfImplicitStage;
    return params.iterations == kAutoIterations ? usual : params.iterations;
}

shared::SolverUniforms solverUniforms(const Params& params) {
    return params.solver == SolverMode::pbd ? pbdUniforms(params) : implicitUniforms(params);
}

void setCounts(shared::SolverUniforms& uniforms, const BodyModel& model) {
    uniforms.vertex_count = static_cast<uint>(model.restPositions.size());
    forEachType(model, [&](auto row, const auto& constraints) {
        uniforms.count[row.kType] = static_cast<uint>(constraints.size());
    });
    uniforms.triangle_count = static_cast<uint>(model.triangles.size());
    uniforms.piece_count = static_cast<uint>(model.pieces.size());
}

shared::SolverUniforms solverUniforms(const Params& params, const BodyModel& model) {
    shared::SolverUniforms u = solverUniforms(params);
    setCounts(u, model);
    return u;
}

}  // namespace kerf
