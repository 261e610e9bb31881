// Adds up how hard the edge of a blade pressed in a stage, and behind the last one of a step how
// far the material has gone ahead of it.
// Numbers: the first row, the share of the step that the stage counts for, as bits, 1 behind the
// last. One group; sums in a fixed order. A storage barrier follows.
#include "sim/base/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
#include "edge_records.h"
layout(local_size_x = kGroupSize) in;
#include "sim/implicit/contact_rows.glsl"
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kRowStatesUnit) states;
STATE_TEXELS(kWayBinding) ways;
layout(std430, binding = kPressEdgeBinding) readonly buffer Edge { EdgeUniforms edge; };
layout(std430, binding = kPressWeightsBinding) readonly buffer Weights { float weights[]; };
layout(std430, binding = kPressStateBinding) buffer State { EdgeState state; };

// x: push [N], y: way ahead times the mass that answers.
shared vec2 sums[kGroupSize];

void main() {
    uint self = gl_LocalInvocationID.x;
    vec2 sum = vec2(0.0);
    for (uint v = self; v < implicit.vertex_count; v += kGroupSize) {
        uint row = numbers.x + v;
        float inverse = fetch(positions, v).w;
        float mass = inverse > 0.0 ? weights[v] * massOf(inverse) : 0.0;
        float push = stiffnessOf(row) > 0.0 ? fetch(states, 2u * row + 1u).y : 0.0;
        sum += vec2(push, mass * dot(edge.ahead.xyz, fetch(ways, v).xyz));
    }
    sums[self] = sum;
    for (uint stride = kGroupSize / 2u; stride > 0u; stride /= 2u) {
        barrier();
        if (self < stride) sums[self] += sums[self + stride];
    }
    if (self != 0u) return;
    float impulse = uintBitsToFloat(numbers.y) * implicit.step * implicit.step * sums[0].x;
    state.impulse += impulse;
    state.work += impulse * edge.way;
    if (numbers.z != 0u) state.gone += sums[0].y / state.middle.w;
}
