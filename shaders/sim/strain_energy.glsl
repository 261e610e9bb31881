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
    vec4 own = fetch(positions, v);
    uvec2 range = fetch(edgeRanges, v).xy;
    float sum = 0.0;
    for (uint k = range.x; k < range.y; ++k) {
        Spoke spoke = fetchSpoke(spokes, k);
        vec4 far = fetch(positions, spoke.other);
        float error = distance(own.xyz, far.xyz) - spoke.rest_length;
        sum += energyOf(error * error, spoke.geometry, kStretch, own.w + far.w);
        float stretch = min(error / max(spoke.rest_length, uniforms.gravity.w), kMostStretch);
        if (stretch > largestStretch) largestStretch = stretch;  // no comparison holds for NaN
    }
    return 0.5 * sum;  // the other end has the other half
}

#include "sim/unfold/folded.glsl"
float largestFold = 0.0;  // of the bends that this thread has summed up

float energyOfBend(BendRecord bend) {
    vec4 x0 = fetch(positions, bend.v0);
    vec4 x1 = fetch(positions, bend.v1);
    vec4 x2 = fetch(positions, bend.v2);
    vec4 x3 = fetch(positions, bend.v3);
    Wings wings = wingsOf((x1 - x0).xyz, (x2 - x0).xyz, (x3 - x0).xyz);
    largestFold = max(largestFold, foldOf(wings, bend));
    if (degenerate(wings)) return 0.0;
    vec2 turn = errorVector(wings, bend);
    float error = abs(inverseTangent(turn.y, turn.x));
    float elastic = min(error, kMaxBendError);
    // Of the apexes alone, which turn it most.
    float e2 = dot(wings.edge, wings.edge);
    float moved = e2 * (x2.w / dot(wings.nA, wings.nA) + x3.w / dot(wings.nB, wings.nB));
    return energyOf(elastic * (2.0 * error - elastic), bend.geometry, kBend, moved);
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
