// Draws vertices towards the goals that they are in. Reads X, rest positions, folds,
// neighbours, goals. Reads and writes velocities. One thread per vertex. A storage barrier follows.
#include "unfold_records.h"
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) before;
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) neighbours;
STATE_TEXELS(kUnfoldRestBinding) restPositions;
RECORD_WORDS(kUnfoldFoldsBinding) folds;
STATE_TEXELS(kUnfoldGoalsBinding) goals;

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 velocityOf(uint v) { return fetch(before, v); }
float foldAt(uint v) { return uintBitsToFloat(fetch(folds, v).x); }
UnfoldGoal goalAt(uint v) {
    uint first = 5u * v;
    return UnfoldGoal(fetch(goals, first), fetch(goals, first + 1u), fetch(goals, first + 2u),
                      fetch(goals, first + 3u), fetch(goals, first + 4u));
}

#include "members.glsl"

// Draws a vertex towards the goals that it is in by damped springs, implicit in the end of the
// substep: its velocity changes by what they do in the mean, each as much as it is folded. A vertex
// without a fold near it keeps its bits.

// How a vertex moves against the rigid motion of a goal [m/s].
vec3 slipOf(UnfoldGoal goal, vec3 toCenter, vec3 velocity) {
    return goal.center.w * (velocity - goal.velocity.xyz + cross(goal.spin.xyz, toCenter));
}

// What one goal changes a velocity by [m/s].
vec3 pullOf(UnfoldGoal goal, vec3 x, vec3 rest, vec3 velocity) {
    vec3 toCenter = goal.center.xyz - x;
    vec3 way =
        goal.rest_center.w * (toCenter + rotated(goal.rotation, rest - goal.rest_center.xyz));
    vec3 slip = slipOf(goal, toCenter, velocity);
    float turn = kUnfoldRate * uniforms.substep;
    return (slip + kUnfoldRate * turn * way) / (1.0 + unfoldDamping() * turn + turn * turn) - slip;
}

// The same where it is at the goal already: what the damping alone does.
vec3 slowingOf(UnfoldGoal goal, vec3 x, vec3 velocity) {
    vec3 slip = slipOf(goal, goal.center.xyz - x, velocity);
    float turn = kUnfoldRate * uniforms.substep;
    return slip / (1.0 + unfoldDamping() * turn + turn * turn) - slip;
}

void unfold(uint v, uvec2 range) {
    float foldSum = foldSumOf(v);
    vec4 x = positionOf(v);
    vec3 velocity = velocityOf(v).xyz;
    vec3 rest = fetch(restPositions, v).xyz;
    vec3 change = vec3(0.0);
    uint count = foldSum > 0.0 && x.w > 0.0 ? memberCount(range) : 0u;
    for (uint i = 0u; i < count; ++i) {
        uint j = memberOf(v, range, i);
        float fold = foldAt(j);
        if (fold > 0.0) {
            // Its share of the mass, and as much of the pull.
            UnfoldGoal goal = goalAt(j);
            change += fold / foldSum * fold * pullOf(goal, x.xyz, rest, velocity);
            // In all as the fold and not as its square: where a load folds what is as soft as its
            // modulus says, it would swing between folded and not.
            change += fold / foldSum * (1.0 - fold) * slowingOf(goal, x.xyz, velocity);
        }
    }
    if (count > 0u) {
        velocities[v] = vec4(velocity + change, 0.0);
    }
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v < uniforms.vertex_count) unfold(v, fetch(ranges, v).xy);
}
