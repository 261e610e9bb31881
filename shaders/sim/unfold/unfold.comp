// Draws each vertex towards the goals that it is in by damped springs, implicit in the end of the
// substep: its velocity changes by what they do in the mean, each as much as it is folded. A vertex
// without a fold near it keeps its bits.
// Reads X, rest positions, folds, their sums, neighbours, goals. Reads and writes velocities. One
// thread per vertex. A storage barrier follows.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kVelocitiesBinding) uniform samplerBuffer before;
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer neighbours;
layout(binding = kUnfoldRestBinding) uniform samplerBuffer restPositions;
layout(binding = kUnfoldFoldsBinding) uniform usamplerBuffer folds;
layout(binding = kUnfoldFoldSumsBinding) uniform usamplerBuffer foldSums;
layout(binding = kUnfoldGoalsBinding) uniform samplerBuffer goals;

#include "sim/unfold/best_rotation.glsl"
#include "sim/unfold/damping.glsl"
#include "sim/unfold/members.glsl"

UnfoldGoal goalAt(uint v) {
    uint first = 5u * v;
    return UnfoldGoal(fetch(goals, first), fetch(goals, first + 1u), fetch(goals, first + 2u),
                      fetch(goals, first + 3u), fetch(goals, first + 4u));
}

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

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uvec2 range = fetch(ranges, v).xy;
    float foldSum = uintBitsToFloat(fetch(foldSums, v).x);
    vec4 x = fetch(positions, v);
    vec3 velocity = fetch(before, v).xyz;
    vec3 rest = fetch(restPositions, v).xyz;
    vec3 change = vec3(0.0);
    bool trueModulus = (uniforms.active_parts & kTrueModulusPart) != 0u;
    uint count = foldSum > 0.0 && x.w > 0.0 ? memberCount(range) : 0u;
    for (uint i = 0u; i < count; ++i) {
        uint j = memberOf(v, range, i);
        float fold = uintBitsToFloat(fetch(folds, j).x);
        if (fold > 0.0) {
            // Its share of the mass, and as much of the pull.
            UnfoldGoal goal = goalAt(j);
            change += fold / foldSum * fold * pullOf(goal, x.xyz, rest, velocity);
            if (trueModulus) {
                // In all as the fold and not as its square: where a load folds what is as soft as
                // its modulus says, it would swing between folded and not.
                change += fold / foldSum * (1.0 - fold) * slowingOf(goal, x.xyz, velocity);
            }
        }
    }
    if (count > 0u) {
        velocities[v] = vec4(velocity + change, 0.0);
    }
}
