// Energy of strained material at X [J]: that of each constraint, and beyond the clamp of a bend
// what its constant moment adds. What is off holds none. The includer declares what
// constraints.glsl wants, `positions` and `restPositions`.
RECORD_PAIRS(kAllRangesUnit) edgeRanges;
RECORD_QUADS(kAllEntriesUnit) spokes;
#define DECLARE(number, Name, list, Constraint, Gather) \
    RECORD_QUADS(kAllRecordsUnit + 3u * number) list##Records;
KERF_PULLING(DECLARE)
#undef DECLARE

#include "sim/constraints.glsl"

float largestStretch = 0.0;  // of the edges that this thread has summed up

float edgeEnergy(uint v) {
    vec3 own = fetch(positions, v).xyz;
    uvec2 range = fetch(edgeRanges, v).xy;
    float sum = 0.0;
    for (uint k = range.x; k < range.y; ++k) {
        Spoke spoke = fetchSpoke(spokes, k);
        float error = distance(own, fetch(positions, spoke.other).xyz) - spoke.rest_length;
        sum += energyOf(error * error, spoke.geometry, kStretch);
        float stretch = min(error / max(spoke.rest_length, uniforms.gravity.w), kMostStretch);
        if (stretch > largestStretch) largestStretch = stretch;  // no comparison holds for NaN
    }
    return 0.5 * sum;  // the other end has the other half
}

#include "sim/unfold/folded.glsl"
float largestFold = 0.0;  // of the bends that this thread has summed up

float energyOfBend(BendRecord bend) {
    vec3 from = fetch(positions, bend.v0).xyz;
    Wings wings = wingsOf(fetch(positions, bend.v1).xyz - from,
                          fetch(positions, bend.v2).xyz - from,
                          fetch(positions, bend.v3).xyz - from);
    largestFold = max(largestFold, foldOf(wings, bend));
    if (degenerate(wings)) return 0.0;
    vec2 turn = errorVector(wings, bend);
    float error = abs(inverseTangent(turn.y, turn.x));
    float elastic = min(error, kMaxBendError);
    return energyOf(elastic * (2.0 * error - elastic), bend.geometry, kBend);
}

uint countIf(uint part, uint count) {
    return (uniforms.active_parts & part) != 0u ? count : 0u;
}

// What thread `first` of `stride` threads sums up, always in the same order.
float strainEnergy(uint first, uint stride) {
    float sum = 0.0;
    uint edgeVertices = countIf(kStretchPart, uniforms.vertex_count);
    for (uint v = first; v < edgeVertices; v += stride) sum += edgeEnergy(v);
#define SUM_UP(number, Name, list, Constraint, Gather)                        \
    uint list##Count = countIf(k##Name##Part, uniforms.count[number]);        \
    for (uint i = first; i < list##Count; i += stride) {                      \
        sum += energyOf##Name(fetch##Name(list##Records, i));                 \
    }
    KERF_PULLING(SUM_UP)
#undef SUM_UP
    return sum;
}
