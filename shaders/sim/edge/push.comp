// Lets the edge of a blade press on the material by a spring, in a substep: implicit, so that it is
// steady however light the material is; never drawing, and no stronger than the edge may be.
// Reads X (inverse mass), weights, the edge. Reads and writes d and the state. One group; sums in a
// fixed order. A storage barrier follows.
#include "body_records.h"
#include "edge_records.h"
layout(local_size_x = kGroupSize) in;

#include "sim/numbers.glsl"
layout(std430, binding = kEdgeUniformsBinding) readonly buffer Uniforms { EdgeUniforms edge; };
layout(std430, binding = kEdgePositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kEdgeDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kEdgeWeightsBinding) readonly buffer Weights { float weights[]; };
layout(std430, binding = kEdgeStateBinding) buffer State { EdgeState state; };

shared float ways[kGroupSize];  // times the mass that answers

void main() {
    uint self = gl_LocalInvocationID.x;
    float way = 0.0;
    for (uint v = self; v < edge.vertex_count; v += kGroupSize) {
        float w = positions[v].w;
        float m = w > 0.0 ? weights[v] / (edge.inverse_density * w) : 0.0;
        way += m * dot(edge.ahead.xyz, displacement[v].xyz);
    }
    ways[self] = way;
    for (uint stride = kGroupSize / 2u; stride > 0u; stride /= 2u) {
        barrier();
        if (self < stride) ways[self] += ways[self + stride];
    }
    barrier();
    float mass = state.middle.w;
    float gone = state.gone + ways[0] / mass;
    float ahead = edge.lag + edge.way * float(numbers.x + 1u) - gone;
    float impulse = clamp(ahead / (state.inverse + edge.to.w), 0.0, edge.ahead.w);
    for (uint v = self; v < edge.vertex_count; v += kGroupSize) {
        vec3 given = (weights[v] * impulse / mass) * edge.ahead.xyz;
        displacement[v] = vec4(displacement[v].xyz + given, 0.0);
    }
    barrier();  // all have read the state
    if (self == 0u) {
        state.gone = gone + impulse * state.inverse;
        state.impulse += impulse;
        state.work += impulse * edge.way;
    }
}
