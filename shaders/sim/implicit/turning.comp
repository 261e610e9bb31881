// How each aggregate turns where a step begins and where it ends: see AggregateMotion.
// Numbers: the slot of what the second stage left. One group for each aggregate. A storage barrier
// follows, then spin.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
#include "sim/implicit/ended.glsl"
STATE_TEXELS(kVelocitiesBinding) velocities;
STATE_TEXELS(kForceBinding) force;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
layout(std430, binding = kMotionsBinding) writeonly buffer Motions { vec4 motions[]; };

shared vec4 partial[kRows][kMotionTexels];
vec4 sums[kMotionTexels];  // of a row

// Of a vertex that moves by itself; `origin` is near it, so that floats keep their digits.
void add(uint v, vec3 origin, vec3 shift) {
    vec4 x = fetch(before, v);
    float mass = massOf(x.w);
    vec3 u = fetch(velocities, v).xyz;
    Ended ended = endOf(v, shift);
    vec3 from = x.xyz - origin;
    vec3 to = ended.place - origin;
    sums[0] += mass * vec4(from, 1.0);
    sums[1] += mass * vec4(to, 0.0);
    sums[2] += mass * vec4(u, 0.0);
    sums[3] += mass * vec4(ended.velocity, 0.0);
    sums[4] += vec4(cross(from, mass * u + implicit.step * fetch(force, v).xyz), 0.0);
    sums[5] += vec4(cross(to, mass * ended.velocity), 0.0);
    sums[6] += mass * vec4(to * to, 0.0);
    sums[7] += mass * vec4(to.yzx * to.zxy, 0.0);
}

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    ImplicitPiece root = pieceAt(pieceAt(own.z).root);
    uint first = fetch(members, fetch(aggregates, root.first_aggregate).x).x;
    vec3 origin = fetch(before, first).xyz;
    vec3 shift = balancingShift(own.z);
    for (uint row = gl_LocalInvocationID.x; row < kRows; row += GROUP) {
        for (uint c = 0u; c < kMotionTexels; ++c) sums[c] = vec4(0.0);
        for (uint k = own.x + row; k < own.y; k += kRows) {
            uint v = fetch(members, k).x;
            if (fetch(before, v).w > 0.0) {
                add(v, origin, shift);
            } else {
                sums[0].w += kHeldMass;
            }
        }
        for (uint c = 0u; c < kMotionTexels; ++c) partial[row][c] = sums[c];
    }
    barrier();
    for (uint c = gl_LocalInvocationID.x; c < kMotionTexels; c += GROUP) {
        vec4 sum = vec4(0.0);
        for (uint row = 0u; row < kRows; ++row) sum += partial[row][c];
        motions[kMotionTexels * gl_WorkGroupID.x + c] = sum;
    }
}
