// The goals of folded vertices (goals.glsl). Reads X, velocities, rest positions, folds,
// neighbours. Writes goals. One thread per vertex: the few that have a fold add the folds of their
// members up themselves. A storage barrier follows, then unfold.
#include "unfold_records.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) neighbours;
STATE_TEXELS(kUnfoldRestBinding) restPositions;
RECORD_WORDS(kUnfoldFoldsBinding) folds;
layout(std430, binding = kUnfoldGoalsBinding) writeonly buffer Goals { UnfoldGoal goals[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 velocityOf(uint v) { return fetch(velocities, v); }
float foldAt(uint v) { return uintBitsToFloat(fetch(folds, v).x); }

#include "sim/unfold/fold_sums.glsl"

float foldSumOf(uint v) { return sumOfFolds(v, fetch(ranges, v).xy); }

#include "sim/unfold/goals.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uvec2 range = fetch(ranges, v).xy;
    for (uint once = fetch(folds, v).x != 0u ? 1u : 0u; once > 0u; --once) {
        goals[v] = goalOf(v, range);
    }
}
