// Ends a step (ended.glsl), with the spin that pieces lack. Keeps what contacts push and hold back,
// and counts those of the body with itself.
// Numbers: the slot of what the second stage left. One group for each aggregate. A storage barrier
// follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
#include "contact_records.h"
#include "sim/implicit/ended.glsl"
STATE_TEXELS(kSpinsUnit) spins;  // two texels a piece: see spin.comp
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
#include "sim/implicit/contact_rows.glsl"
STATE_TEXELS(kRowStatesUnit) states;
layout(std430, binding = kPositionsBinding) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = kKeptSlipsBinding) writeonly buffer Kept { vec4 kept[]; };
layout(std430, binding = kEndContactsBinding) buffer Contacts { ContactState contacts; };

// The push [N], and the slip that friction still holds [m], of what slides the normal.
vec4 keptOf(uint row) {
    float stiffness = stiffnessOf(row);
    vec3 slip = fetch(states, 2u * row).xyz;
    float push = fetch(states, 2u * row + 1u).y;
    if (!(stiffness > 0.0) || !(push > 0.0)) return vec4(0.0);
    if (fetch(rows, kRowTexels * row + 3u).w < 0.0) {
        return vec4(fetch(rows, kRowTexels * row).xyz, push);
    }
    return vec4(gripOf(stiffness, slip, implicit.contact.friction * push) / stiffness * slip, push);
}

// In one of the stages.
bool isPushed(uint row) {
    vec4 pushes = fetch(states, 2u * row + 1u);
    return stiffnessOf(row) > 0.0 && max(pushes.y, pushes.z) > 0.0;
}

bool touchesBody(uint v) {
    return isPushed(kRowsOfVertex * v + kMeetsTriangle) ||
        isPushed(kRowsOfVertex * v + kMeetsEdge);
}

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    vec3 shift = balancingShift(own.z);
    vec3 spin = fetch(spins, 2u * own.z).xyz;
    vec3 middle = fetch(spins, 2u * own.z + 1u).xyz;
    for (uint k = own.x + gl_LocalInvocationID.x; k < own.y; k += GROUP) {
        uint v = fetch(members, k).x;
        for (uint r = 0u; r < kRowsOfVertex; ++r) {
            kept[kRowsOfVertex * v + r] = keptOf(kRowsOfVertex * v + r);
        }
        if (touchesBody(v)) atomicAdd(contacts.last_contacts, 1u);
        vec4 x = fetch(before, v);
        if (x.w > 0.0) {
            Ended ended = endOf(v, shift);
            positions[v] = vec4(ended.place, x.w);
            velocities[v] = vec4(ended.velocity + cross(spin, ended.place - middle), 0.0);
        }
    }
}
