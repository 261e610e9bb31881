// The numbers of the step: see sim/base/uniforms.glsl.
#pragma once
#include "bindings.h"
#include "body_records.h"
#include "implicit_records.h"
#include "solver_uniforms.h"
#include "sim/base/fetch.glsl"

layout(std430, binding = kImplicitBinding) readonly buffer Implicit {
    ImplicitUniforms storedImplicit;
};
ImplicitUniforms implicit = storedImplicit;

// What a constraint may be as firm as, of which this is the sum of |grad C|^2 over unit mass.
float boundedFirmness(float stiffness, float moved) {
    return min(stiffness, implicit.bounds.firmest / max(implicit.inverse_density * moved, 1e-30));
}

float massOf(float inverseUnitMass) {
    return 1.0 / (implicit.inverse_density * inverseUnitMass);
}
