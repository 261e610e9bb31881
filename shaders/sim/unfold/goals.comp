// The goals of folded vertices (goals.glsl). Reads X, velocities, rest positions, folds, their
// sums, neighbours. Writes goals. One thread per vertex. A storage barrier follows, then unfold.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kVelocitiesBinding) uniform samplerBuffer velocities;
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer neighbours;
layout(binding = kUnfoldRestBinding) uniform samplerBuffer restPositions;
layout(binding = kUnfoldFoldsBinding) uniform usamplerBuffer folds;
layout(std430, binding = kUnfoldGoalsBinding) writeonly buffer Goals { UnfoldGoal goals[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 velocityOf(uint v) { return fetch(velocities, v); }
float foldSumOf(uint v) {
    return uintBitsToFloat(fetch(folds, uniforms.vertex_count + v).x);
}

#include "sim/unfold/goals.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uvec2 range = fetch(ranges, v).xy;
    for (uint once = fetch(folds, v).x != 0u ? 1u : 0u; once > 0u; --once) {
        goals[v] = goalOf(v, range);
    }
}
