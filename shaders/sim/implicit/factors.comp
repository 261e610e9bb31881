// What constraints of one type resist motion by at X: of each slot, that is of each vertex, a
// texel of which the blocks of the matrix are sums of products,
//   xyz  gradient * sqrt(stiffness along it)    w  weight * sqrt(stiffness across it)
// and of each constraint its force over that root. Of an edge both its spokes have their own.
// Numbers: how many there are, the first texel, and of those that are bound the first and how many.
// One thread per constraint, or place of a spoke. A storage barrier follows, then blocks.
#include "constraints.h"
#include "sim/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
RECORD_QUADS(kConstraintsBinding) records;
layout(std430, binding = kMadeFactorsBinding) writeonly buffer Factors { vec4 factors[]; };
layout(std430, binding = kMadePullsBinding) writeonly buffer Pulls { float pulls[]; };

void storeFactor(uint at, vec4 factor) {
    if (at - numbers.z < numbers.w) factors[at - numbers.z] = factor;
}

// Of a constraint whose texels begin at `at`.
void setPull(uint at, float pull) { pulls[at / 2u] = pull; }

#ifdef OF_EDGES
#include "sim/implicit/edge_factors.glsl"
#elif defined(OF_BENDS)
#include "sim/implicit/bend_factors.glsl"
#else
#include "sim/implicit/ispc_factors.glsl"
#endif

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < numbers.x) setFactors(index, numbers.y);
}
