// Copied before anything branches, as those of the solver (sim/uniforms.glsl).
layout(std430, binding = kContactUniformsBinding) readonly buffer Uniforms {
    ContactUniforms storedUniforms;
};
ContactUniforms uniforms = storedUniforms;
