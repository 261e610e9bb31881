// Adds to d and X of each vertex what its touches sum up to, and clears the sums for the next
// substep. One thread per vertex. A storage barrier follows.
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kBoxSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kBoxSumsBinding) buffer Sums { int sums[]; };

#include "sim/fixed_sums.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count || shares[v] == 0u) return;
    shares[v] = 0u;
    displacement[v] = vec4(displacement[v].xyz + takeSum(6u * v, uniforms.unit), 0.0);
    positions[v] = vec4(positions[v].xyz + takeSum(6u * v + 3u, uniforms.unit), positions[v].w);
}
