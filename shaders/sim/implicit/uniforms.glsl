// The numbers of the step: see sim/uniforms.glsl.
#pragma once
#include "bindings.h"
#include "body_records.h"
#include "implicit_records.h"
#include "solver_uniforms.h"
#include "sim/fetch.glsl"

layout(std430, binding = kImplicitBinding) readonly buffer Implicit {
    ImplicitUniforms storedImplicit;
};
ImplicitUniforms implicit = storedImplicit;

float massOf(float inverseUnitMass) {
    return 1.0 / (implicit.inverse_density * inverseUnitMass);
}
