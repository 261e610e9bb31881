// The blocks beside the diagonal of (1 + 2 beta / h) K at X, each a sum of products of factors:
// three texels, one a row, with the column in the w of the first.
// Numbers: the first block that is bound, and how many. One thread per block.
#include "sim/base/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
RECORD_QUADS(kBlockListUnit) blockList;
layout(std430, binding = kMadeBlocksBinding) writeonly buffer Blocks { vec4 blocks[]; };
#include "sim/implicit/factor_shares.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= implicit.block_count) return;
    uvec4 block = fetch(blockList, index);  // ImplicitBlock
    uint place = block.x - numbers.x;
    if (place >= numbers.y) return;
    vec3 x = vec3(0.0);
    vec3 y = vec3(0.0);
    vec3 z = vec3(0.0);
    float across = 0.0;
    for (uint k = block.z; k < block.w; ++k) {
        uint share = fetch(blockShares, k).x;
        uint at = factorsOf(share);
        vec4 a = fetch(factors, at + (share >> 2 & 3u));
        vec4 b = fetch(factors, at + (share & 3u));
        x += a.x * b.xyz;
        y += a.y * b.xyz;
        z += a.z * b.xyz;
        across += a.w * b.w;
    }
    blocks[3u * place] = vec4(x + vec3(across, 0.0, 0.0), float(block.y));
    blocks[3u * place + 1u] = vec4(y + vec3(0.0, across, 0.0), 0.0);
    blocks[3u * place + 2u] = vec4(z + vec3(0.0, 0.0, across), 0.0);
}
