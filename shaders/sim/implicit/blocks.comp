// The blocks beside the diagonal of the matrix M / s^2 + (1 + 2 beta / h) K at X: three texels
// each, one a row, with the column in the w of the first. One thread per block.
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
RECORD_QUADS(kBlockListUnit) blockList;
layout(std430, binding = kMadeBlocksBinding) writeonly buffer Blocks { vec4 blocks[]; };

#include "sim/implicit/block_sum.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= implicit.block_count) return;
    uvec4 block = fetch(blockList, index);  // ImplicitBlock
    BlockSum sum = BlockSum(vec3(0.0), vec3(0.0), vec3(0.0));
    for (uint k = block.z; k < block.w; ++k) {
        uint share = fetch(blockShares, k).x;
        uint at = factorsOf(share);
        addTo(sum, fetch(factors, at + (share >> 2 & 3u)), fetch(factors, at + (share & 3u)));
    }
    blocks[3u * block.x] = vec4(sum.x, float(block.y));
    blocks[3u * block.x + 1u] = vec4(sum.y, 0.0);
    blocks[3u * block.x + 2u] = vec4(sum.z, 0.0);
}
