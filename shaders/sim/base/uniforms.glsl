// The numbers of the substep, copied before anything branches: behind a branch llvmpipe reads
// storage lane by lane, even where all lanes read the same word.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms {
    SolverUniforms storedUniforms;
};
SolverUniforms uniforms = storedUniforms;
