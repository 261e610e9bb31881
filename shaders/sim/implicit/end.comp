// Ends a step: X += way, v = (X - from) / s exp(-c h). Numbers: the slot of what the second stage
// left. One group for each aggregate. A storage barrier follows.
#include "sim/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
#include "sim/implicit/balance.glsl"
STATE_TEXELS(kPositionsBinding) before;
STATE_TEXELS(kWayBinding) ways;
STATE_TEXELS(kFirstWayBinding) firstWays;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
layout(std430, binding = kPositionsBinding) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    vec3 shift = balancingShift(own.z, numbers.x);
    for (uint k = own.x + gl_LocalInvocationID.x; k < own.y; k += GROUP) {
        uint v = fetch(members, k).x;
        vec4 x = fetch(before, v);
        if (x.w > 0.0) {
            vec3 way = fetch(ways, v).xyz + shift;
            vec3 last = way - (implicit.rest / implicit.stage) * fetch(firstWays, v).xyz;
            positions[v] = vec4(x.xyz + way, x.w);
            velocities[v] = vec4((implicit.kept / implicit.stage) * last, 0.0);
        }
    }
}
