// How pieces that nothing holds are to spin besides, so that they have the angular momentum that
// the forces on them say: vertices move along straight lines in a step, so what turns lost some.
// One group for each piece, of which the first of those that touch works for all of them. A storage
// barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/pieces.glsl"
#include "sim/unfold/spin.glsl"
STATE_TEXELS(kPositionsBinding) before;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
STATE_TEXELS(kMotionsUnit) motions;
layout(std430, binding = kMadeSpinsBinding) writeonly buffer Spins { vec4 spins[]; };

shared vec4 sums[kMotionTexels];

vec4 sumOf(uint root, uint c) {
    vec4 sum = vec4(0.0);
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        ImplicitPiece piece = pieceAt(p);
        for (uint k = 0u; k < piece.aggregate_count; ++k) {
            sum += fetch(motions, kMotionTexels * (piece.first_aggregate + k) + c);
        }
    }
    return sum;
}

bool isHeld(uint root) {
    bool held = false;
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        held = held || pieceAt(p).force_unit < 0.0;
    }
    return held;
}

vec3 spinOfAll(vec3 middle, float mass) {
    vec3 turnBefore = sums[4].xyz - cross(sums[0].xyz, sums[2].xyz) / mass;
    vec3 turnAfter = sums[5].xyz - cross(sums[1].xyz, sums[3].xyz) / mass;
    vec3 squares = sums[6].xyz - mass * middle * middle;
    vec3 mixed = sums[7].xyz - mass * middle.yzx * middle.zxy;
    return spinOf(implicit.kept * turnBefore - turnAfter, squares, mixed).xyz;
}

void main() {
    uint root = gl_WorkGroupID.x;
    if (pieceAt(root).root != root) return;
    for (uint c = gl_LocalInvocationID.x; c < kMotionTexels; c += GROUP) sums[c] = sumOf(root, c);
    barrier();
    if (gl_LocalInvocationID.x != 0u) return;
    float mass = sums[0].w;
    bool isFree = mass > 0.0 && mass < kHeldMass && !isHeld(root);
    vec3 middle = sums[1].xyz / mass;
    vec3 spin = isFree ? spinOfAll(middle, mass) : vec3(0.0);
    uint first = fetch(members, fetch(aggregates, pieceAt(root).first_aggregate).x).x;
    vec3 origin = fetch(before, first).xyz;
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        spins[2u * p] = vec4(spin, 0.0);
        spins[2u * p + 1u] = vec4(isFree ? origin + middle : vec3(0.0), 0.0);
    }
}
