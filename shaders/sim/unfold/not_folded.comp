// Before folds are found: no vertex is folded. Writes folds. One thread per vertex. A storage
// barrier follows. It is no clear by the driver, since zink is known to move those.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
#include "unfold_records.h"
layout(local_size_x = kGroupSize) in;

#include "sim/uniforms.glsl"

layout(std430, binding = kUnfoldFoldsBinding) writeonly buffer Folds { uint folds[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v < uniforms.vertex_count) folds[v] = 0u;
}
