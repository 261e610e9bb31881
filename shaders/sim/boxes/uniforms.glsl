// Copied before anything branches, as those of the solver (sim/uniforms.glsl).
layout(std430, binding = kBoxUniformsBinding) readonly buffer Uniforms {
    BoxUniforms storedUniforms;
};
BoxUniforms uniforms = storedUniforms;
