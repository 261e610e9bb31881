// Ends the iterations of a stage: goes along the last direction, and leaves sums of the residual,
// by which begin.comp and end.comp give a piece the momentum that it should have.
// Numbers: the slot, that of the sums. One group for each aggregate. A storage barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/last_group.glsl"
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kGradientsBinding) gradients;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
#include "sim/implicit/advance.glsl"

const uint kSumGroups = 8u;
shared vec4 lefts[kMostMembers];
shared vec4 leftRows[kSumGroups];

// By which pieces are moved as a whole, so that their momentum is what the forces on them say,
// however few the iterations. Not where a vertex is held.
void leaveShifts(uint root) {
    vec4 left = vec4(0.0);
    for (uint p = root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        left += sumOfAnswers(piece, numbers.y).second;
        p = piece.next;
    }
    if (gl_LocalInvocationID.x != 0u) return;
    vec3 shift = left.w < kHeldMass ? left.xyz / (implicit.inertia * left.w) : vec3(0.0);
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) newCourses[p].shift = vec4(shift, 0.0);
}

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    uint count = own.y - own.x;
    prepare(own.z);
    for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
        uint v = fetch(members, own.x + k).x;
        float inverseUnitMass = fetch(positions, v).w;
        vec3 left = residualOf(v);
        lefts[k] = inverseUnitMass > 0.0 ? vec4(left, massOf(inverseUnitMass))
                                         : vec4(0.0, 0.0, 0.0, kHeldMass);
    }
    barrier();
    for (uint row = gl_LocalInvocationID.x; row < kSumGroups; row += GROUP) {
        vec4 sum = vec4(0.0);
        for (uint k = row; k < count; k += kSumGroups) sum += lefts[k];
        leftRows[row] = sum;
    }
    barrier();
    if (gl_LocalInvocationID.x == 0u) {
        vec4 sum = vec4(0.0);
        for (uint row = 0u; row < kSumGroups; ++row) sum += leftRows[row];
        uint at = 2u * (numbers.y * implicit.aggregate_count + gl_WorkGroupID.x);
        newSums[at] = vec4(0.0);
        newSums[at + 1u] = sum;
    }
    ImplicitPiece piece = pieceAt(own.z);
    if (isLastGroup(piece)) leaveShifts(piece.root);
}
