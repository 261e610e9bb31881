// The goal of v and its members, whose neighbours lie at `range`. The includer declares `uniforms`,
// `neighbours`, which is read by pairs, `ranges`, foldAt(v).
#include "best_rotation.glsl"

// v itself, then its neighbours.
uint memberOf(uint v, uvec2 range, uint i) {
    uint place = range.x + max(i, 1u) - 1u;
    uvec2 pair = fetch(neighbours, place / 2u).xy;
    return i == 0u ? v : ((place & 1u) == 0u ? pair.x : pair.y) & ~kAfterGap;
}

uint memberCount(uvec2 range) {
    return range.y - range.x + 1u;
}

// The sum of the folds of the goals that a vertex is in: its own and those of its neighbours.
float foldSumOf(uint v) {
    uvec2 range = fetch(ranges, v).xy;
    float sum = 0.0;
    for (uint i = 0u; i < memberCount(range); ++i) {
        sum += foldAt(memberOf(v, range, i));
    }
    return sum;
}

// The damping of the springs that unfold, in this step.
float unfoldDamping() {
    return (uniforms.active_parts & kUnfoldFirmlyPart) != 0u ? kFirmUnfoldDamping : kUnfoldDamping;
}
