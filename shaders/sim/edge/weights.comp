// How much each vertex answers to the edge of a blade in a time step, and what they answer as.
// Reads X (inverse mass), the edge. Writes weights and the state, with nothing done yet. One group;
// sums in a fixed order. A storage barrier follows.
#include "body_records.h"
#include "edge_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kEdgeUniformsBinding) readonly buffer Uniforms { EdgeUniforms edge; };
layout(std430, binding = kEdgePositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kEdgeWeightsBinding) writeonly buffer Weights { float weights[]; };
layout(std430, binding = kEdgeStateBinding) writeonly buffer State { EdgeState state; };

shared vec4 masses[kGroupSize];  // xyz: times where they lie
shared float squares[kGroupSize];

// An eighth at the reach; never 0, so that there is an answer wherever the skin is.
float weightAt(vec3 p) {
    vec3 along = edge.to.xyz - edge.from.xyz;
    float place = clamp(dot(p, along) / max(dot(along, along), 1e-30), 0.0, 1.0);
    vec3 off = (p - place * along) / edge.from.w;
    float near = 1.0 / (1.0 + dot(off, off));
    return near * near * near;
}

void main() {
    uint self = gl_LocalInvocationID.x;
    vec4 mass = vec4(0.0);
    float square = 0.0;
    for (uint v = self; v < edge.vertex_count; v += kGroupSize) {
        vec4 x = positions[v];
        vec3 p = x.xyz - edge.from.xyz;
        float weight = x.w > 0.0 ? weightAt(p) : 0.0;
        float m = x.w > 0.0 ? weight / (edge.inverse_density * x.w) : 0.0;
        weights[v] = weight;
        mass += m * vec4(p, 1.0);
        square += m * weight;
    }
    masses[self] = mass;
    squares[self] = square;
    for (uint stride = kGroupSize / 2u; stride > 0u; stride /= 2u) {
        barrier();
        if (self < stride) {
            masses[self] += masses[self + stride];
            squares[self] += squares[self + stride];
        }
    }
    if (self == 0u) {
        float all = max(masses[0].w, 1e-30);
        state = EdgeState(vec4(masses[0].xyz / all, all), squares[0] / (all * all), 0.0, 0.0, 0.0);
    }
}
