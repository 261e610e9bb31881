// Ends a step: X += way, v = (X - from) / s exp(-c h). Keeps what contacts push and hold back.
// Numbers: the slot of what the second stage left. One group for each aggregate. A storage barrier
// follows.
#include "sim/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
#include "sim/implicit/balance.glsl"
STATE_TEXELS(kPositionsBinding) before;
STATE_TEXELS(kWayBinding) ways;
STATE_TEXELS(kFirstWayBinding) firstWays;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
#include "sim/implicit/contact_rows.glsl"
STATE_TEXELS(kRowStatesUnit) states;
layout(std430, binding = kPositionsBinding) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = kKeptSlipsBinding) writeonly buffer Kept { vec4 kept[]; };

void keep(uint row) {
    float stiffness = fetch(rows, 3u * row + 1u).w;
    vec4 state = fetch(states, 2u * row);
    float push = stiffness > 0.0 ? fetch(states, 2u * row + 1u).y : 0.0;
    float share = push > 0.0
        ? gripOf(stiffness, state.xyz, implicit.friction * push) / stiffness
        : 0.0;
    kept[row] = vec4(share > 0.0 ? share * state.xyz : vec3(0.0), push);
}

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    vec3 shift = balancingShift(own.z, numbers.x);
    for (uint k = own.x + gl_LocalInvocationID.x; k < own.y; k += GROUP) {
        uint v = fetch(members, k).x;
        keep(2u * v);
        keep(2u * v + 1u);
        vec4 x = fetch(before, v);
        if (x.w > 0.0) {
            vec3 way = fetch(ways, v).xyz + shift;
            vec3 last = way - (implicit.rest / implicit.stage) * fetch(firstWays, v).xyz;
            positions[v] = vec4(x.xyz + way, x.w);
            velocities[v] = vec4((implicit.kept / implicit.stage) * last, 0.0);
        }
    }
}
