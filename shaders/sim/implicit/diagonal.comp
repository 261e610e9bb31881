// The blocks on the diagonal of the matrix (blocks.comp), and the elastic forces at X. One thread
// per vertex.
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kPullsUnit) pulls;
RECORD_QUADS(kDiagonalUnit) diagonal;
layout(std430, binding = kMadeBlocksBinding) writeonly buffer Blocks { vec4 blocks[]; };
layout(std430, binding = kForceBinding) writeonly buffer Force { vec4 force[]; };

#include "sim/implicit/block_sum.glsl"

float pullOf(uint at) {
    vec4 four = fetch(pulls, at / 8u);
    uint k = at / 2u % 4u;
    return k < 2u ? (k == 0u ? four.x : four.y) : (k == 2u ? four.z : four.w);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    uvec4 block = fetch(diagonal, v);  // ImplicitBlock
    if (block.z == block.w) return;
    BlockSum sum = BlockSum(vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 pulled = vec3(0.0);
    for (uint k = block.z; k < block.w; ++k) {
        uint share = fetch(blockShares, k).x;
        uint at = factorsOf(share);
        vec4 factor = fetch(factors, at + (share & 3u));
        addTo(sum, factor, factor);
        pulled -= pullOf(at) * factor.xyz;
    }
    float inverseUnitMass = fetch(positions, v).w;
    float inertia = inverseUnitMass > 0.0 ? implicit.inertia * massOf(inverseUnitMass) : 1.0;
    force[v] = vec4(pulled, 0.0);
    blocks[3u * block.x] = vec4(sum.x + vec3(inertia, 0.0, 0.0), float(v));
    blocks[3u * block.x + 1u] = vec4(sum.y + vec3(0.0, inertia, 0.0), 0.0);
    blocks[3u * block.x + 2u] = vec4(sum.z + vec3(0.0, 0.0, inertia), 0.0);
}
