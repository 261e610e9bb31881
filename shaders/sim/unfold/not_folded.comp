// Before folds are found: no vertex is folded. Writes folds. One thread per vertex. A storage
// barrier follows. It is no clear by the driver, since zink is known to move those.
#include "unfold_records.h"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kUnfoldFoldsBinding) writeonly buffer Folds { uint folds[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v < uniforms.vertex_count) folds[v] = 0u;
}
