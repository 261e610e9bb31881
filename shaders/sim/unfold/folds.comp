// How far the skin at the bends of each vertex is folded at X, at most. A bend with a vertex that
// has no inverse mass does not count: its rings are not drawn (goals.comp), and walls beside the
// front of a slit must stay damped and in contact, else they crumple into the way of the blade.
// Reads X, rest positions, bends. Writes folds, which are zero before. One thread per bend; the
// largest of floats does not mind their order. A storage barrier follows.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kUnfoldRestBinding) uniform samplerBuffer restPositions;
layout(binding = kUnfoldBendsBinding) uniform usamplerBuffer bends;
layout(std430, binding = kUnfoldFoldsBinding) buffer Folds { uint folds[]; };

#include "sim/unfold/folded.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.count[kBend]) return;
    BendRecord bend = fetchBend(bends, index);
    vec4 x0 = fetch(positions, bend.v0);
    vec4 x1 = fetch(positions, bend.v1);
    vec4 x2 = fetch(positions, bend.v2);
    vec4 x3 = fetch(positions, bend.v3);
    bool free = min(min(x0.w, x1.w), min(x2.w, x3.w)) > 0.0;
    Wings wings = wingsOf(x1.xyz - x0.xyz, x2.xyz - x0.xyz, x3.xyz - x0.xyz);
    float fold = free ? foldOf(wings, bend) : 0.0;
    // Positive floats and their bits have the same order.
    for (uint once = fold > 0.0 ? 1u : 0u; once > 0u; --once) {
        atomicMax(folds[bend.v0], floatBitsToUint(fold));
        atomicMax(folds[bend.v1], floatBitsToUint(fold));
        atomicMax(folds[bend.v2], floatBitsToUint(fold));
        atomicMax(folds[bend.v3], floatBitsToUint(fold));
    }
}
