// How far the skin at the bends of each vertex is folded at X, at most. A bend with a vertex that
// has no inverse mass does not count: its rings are not drawn (goals.comp), and walls beside the
// front of a slit must stay damped and in contact, else they crumple into the way of the blade.
// Reads X, rest positions, bends. Writes folds, which are zero before. One thread per bend; the
// largest of floats does not mind their order. A storage barrier follows.
#include "unfold_records.h"
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kUnfoldRestBinding) restPositions;
RECORD_QUADS(kUnfoldBendsBinding) bends;
layout(std430, binding = kUnfoldFoldsBinding) buffer Folds { uint folds[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
#include "sim/base/folded.glsl"

// Positive floats and their bits have the same order.
void raiseFold(uint v, float fold) { atomicMax(folds[v], floatBitsToUint(fold)); }

// Raises the fold of each vertex of a bend to that of the bend at X.
void raiseFolds(BendRecord bend) {
    vec4 x0 = positionOf(bend.v0);
    vec4 x1 = positionOf(bend.v1);
    vec4 x2 = positionOf(bend.v2);
    vec4 x3 = positionOf(bend.v3);
    bool free = min(min(x0.w, x1.w), min(x2.w, x3.w)) > 0.0;
    Wings wings = wingsOf(x1.xyz - x0.xyz, x2.xyz - x0.xyz, x3.xyz - x0.xyz);
    float fold = free ? foldOf(wings, bend) : 0.0;
    for (uint once = fold > 0.0 ? 1u : 0u; once > 0u; --once) {
        raiseFold(bend.v0, fold);
        raiseFold(bend.v1, fold);
        raiseFold(bend.v2, fold);
        raiseFold(bend.v3, fold);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.count[kBend]) return;
    raiseFolds(fetchBend(bends, index));
}
