// The sum of the folds of the goals that a vertex is in: its own and those of its neighbours.
// Reads folds, neighbours. Writes sums. One thread per vertex. A storage barrier follows.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer neighbours;
layout(binding = kUnfoldFoldsBinding) uniform usamplerBuffer folds;
layout(std430, binding = kUnfoldFoldSumsBinding) writeonly buffer FoldSums { float foldSums[]; };

#include "sim/unfold/members.glsl"

float foldAt(uint v) { return uintBitsToFloat(fetch(folds, v).x); }

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uvec2 range = fetch(ranges, v).xy;
    float sum = 0.0;
    for (uint i = 0u; i < memberCount(range); ++i) {
        sum += foldAt(memberOf(v, range, i));
    }
    foldSums[v] = sum;
}
