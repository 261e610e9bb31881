// Energy of strained material at X [J]: C^2 / (2 alpha) of each constraint, and beyond the clamp of
// a bend what its constant moment adds. What is rigid or off holds none. The includer declares
// `uniforms`, `positions` and `restPositions`.
layout(binding = kEdgeRangesBinding) uniform usamplerBuffer edgeRanges;
layout(binding = kSpokesBinding) uniform usamplerBuffer spokes;
layout(binding = kBendsBinding) uniform usamplerBuffer bends;
layout(binding = kIspcsBinding) uniform usamplerBuffer ispcs;

// `square`: C^2, or what stands for it; `compliance` over h^2.
float energyOf(float square, float geometry, float compliance) {
    float alpha = geometry * compliance * uniforms.substep * uniforms.substep;
    return alpha > 0.0 ? 0.5 * square / alpha : 0.0;
}

float edgeEnergy(uint v) {
    vec3 own = fetch(positions, v).xyz;
    uvec2 range = fetch(edgeRanges, v).xy;
    float sum = 0.0;
    for (uint k = range.x; k < range.y; ++k) {
        Spoke spoke = fetchSpoke(spokes, k);
        float error = distance(own, fetch(positions, spoke.other).xyz) - spoke.rest_length;
        sum += energyOf(error * error, spoke.geometry, uniforms.stretch_compliance);
    }
    return 0.5 * sum;  // the other end has the other half
}

#include "sim/unfold/folded.glsl"
float largestFold = 0.0;  // of the bends that this thread has summed up

float bendEnergy(uint index) {
    BendRecord bend = fetchBend(bends, index);
    vec3 from = fetch(positions, bend.v0).xyz;
    Wings wings = wingsOf(fetch(positions, bend.v1).xyz - from,
                          fetch(positions, bend.v2).xyz - from,
                          fetch(positions, bend.v3).xyz - from);
    largestFold = max(largestFold, foldOf(wings, bend));
    if (degenerate(wings)) return 0.0;
    vec2 turn = errorVector(wings, bend);
    float error = abs(inverseTangent(turn.y, turn.x));
    float elastic = min(error, kMaxBendError);
    return energyOf(elastic * (2.0 * error - elastic), bend.geometry, uniforms.bend_compliance);
}

float ispcEnergy(uint index) {
    IspcConstraint ispc = fetchIspc(ispcs, index);
    vec3 x = fetch(positions, ispc.vertex).xyz;
    vec3 span = (1.0 - ispc.b1 - ispc.b2) * (x - fetch(positions, ispc.t0).xyz) +
        ispc.b1 * (x - fetch(positions, ispc.t1).xyz) +
        ispc.b2 * (x - fetch(positions, ispc.t2).xyz);
    float error = length(span) - ispc.rest_length;
    return energyOf(error * error, ispc.geometry, uniforms.ispc_compliance);
}

uint countIf(uint part, uint count) {
    return (uniforms.active_parts & part) != 0u ? count : 0u;
}

// What thread `first` of `stride` threads sums up, always in the same order.
float strainEnergy(uint first, uint stride) {
    float sum = 0.0;
    uint edgeVertices = countIf(kStretchPart, uniforms.vertex_count);
    uint bendCount = countIf(kBendPart, uniforms.bend_count);
    uint ispcCount = countIf(kIspcPart, uniforms.ispc_count);
    for (uint v = first; v < edgeVertices; v += stride) sum += edgeEnergy(v);
    for (uint i = first; i < bendCount; i += stride) sum += bendEnergy(i);
    for (uint i = first; i < ispcCount; i += stride) sum += ispcEnergy(i);
    return sum;
}
