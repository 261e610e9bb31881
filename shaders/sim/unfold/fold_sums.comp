// The sum of the folds of the goals that a vertex is in: its own and those of its neighbours.
// Reads folds, neighbours. Writes sums. One thread per vertex. A storage barrier follows.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer neighbours;
layout(std430, binding = kUnfoldFoldsBinding) buffer Folds { float folds[]; };

float foldAt(uint v) { return folds[v]; }

#include "sim/unfold/fold_sums.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    folds[uniforms.vertex_count + v] = sumOfFolds(v, fetch(ranges, v).xy);
}
