// How far the skin at the bends of each vertex is folded at X, at most. A bend with a vertex that
// has no inverse mass does not count: its rings are not drawn (goals.comp), and walls beside the
// front of a slit must stay damped and in contact, else they crumple into the way of the blade.
// Reads X, rest positions, bends. Writes folds, which are zero before. One thread per bend; the
// largest of floats does not mind their order. A storage barrier follows.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kUnfoldRestBinding) restPositions;
RECORD_QUADS(kUnfoldBendsBinding) bends;
layout(std430, binding = kUnfoldFoldsBinding) buffer Folds { uint folds[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
// Positive floats and their bits have the same order.
void raiseFold(uint v, float fold) { atomicMax(folds[v], floatBitsToUint(fold)); }

#include "sim/unfold/folded.glsl"
#include "sim/unfold/raise_folds.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.count[kBend]) return;
    raiseFolds(fetchBend(bends, index));
}
