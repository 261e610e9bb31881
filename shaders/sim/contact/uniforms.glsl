// Copied before anything branches, as those of the solver (sim/base/uniforms.glsl).
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"

layout(std430, binding = kContactUniformsBinding) readonly buffer Uniforms {
    ContactUniforms storedUniforms;
};
ContactUniforms uniforms = storedUniforms;
