// Draws vertices towards the goals that they are in (pulls.glsl). Reads X, rest positions, folds,
// neighbours, goals. Reads and writes velocities. One thread per vertex. A storage barrier follows.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
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
void setVelocity(uint v, vec3 u) { velocities[v] = vec4(u, 0.0); }
float foldAt(uint v) { return uintBitsToFloat(fetch(folds, v).x); }
UnfoldGoal goalAt(uint v) {
    uint first = 5u * v;
    return UnfoldGoal(fetch(goals, first), fetch(goals, first + 1u), fetch(goals, first + 2u),
                      fetch(goals, first + 3u), fetch(goals, first + 4u));
}

#include "sim/unfold/fold_sums.glsl"

float foldSumOf(uint v) { return sumOfFolds(v, fetch(ranges, v).xy); }

#include "sim/unfold/pulls.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v < uniforms.vertex_count) unfold(v, fetch(ranges, v).xy);
}
