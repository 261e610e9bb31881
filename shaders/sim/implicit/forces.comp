// The elastic forces at X: sums over what constraints pull their vertices by (factors.comp). One
// thread per vertex.
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPullsUnit) pulls;
RECORD_PAIRS(kOwnSharesUnit) ownShares;
layout(std430, binding = kForceBinding) writeonly buffer Force { vec4 force[]; };
#include "sim/implicit/factor_shares.glsl"

float pullOf(uint at) {
    vec4 four = fetch(pulls, at / 8u);
    uint k = at / 2u % 4u;
    return k < 2u ? (k == 0u ? four.x : four.y) : (k == 2u ? four.z : four.w);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    uvec2 own = fetch(ownShares, v).xy;
    vec3 pulled = vec3(0.0);
    for (uint k = own.x; k < own.y; ++k) {
        uint share = fetch(blockShares, k).x;
        uint at = factorsOf(share);
        pulled -= pullOf(at) * fetch(factors, at + (share & 3u)).xyz;
    }
    force[v] = vec4(pulled, 0.0);
}
