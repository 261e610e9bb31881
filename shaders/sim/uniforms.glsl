// The numbers of the substep, copied before anything branches: behind a branch llvmpipe reads
// storage lane by lane, even where all lanes read the same word.
layout(std430, binding = kUniformsBinding) readonly buffer Uniforms {
    SolverUniforms storedUniforms;
};
SolverUniforms uniforms = storedUniforms;
