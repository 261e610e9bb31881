// Solves each touch of a box and a triangle once: mass-splitting Jacobi, see mass_shares.glsl.
// Reads X (inverse mass), touches, shares. Adds to sums. One thread per triangle. A storage barrier
// follows, then apply.
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kBoxRecordsBinding) readonly buffer Records { BoxTouch records[]; };
layout(std430, binding = kBoxSharesBinding) readonly buffer Shares { uint shares[]; };
layout(std430, binding = kBoxSumsBinding) buffer Sums { int sums[]; };

#include "sim/fixed_sums.glsl"
#include "sim/mass_shares.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.triangle_count) return;
    BoxTouch record = records[index];
    if (record.impulse.w == 0.0) return;
    uvec3 t = triangles[index].xyz;
    vec3 b = record.weights.xyz;
    vec3 w = uniforms.inverse_density * vec3(positions[t.x].w, positions[t.y].w, positions[t.z].w);
    float weight = 0.0;
    for (int k = 0; k < 3; ++k) {
        weight += w[k] * sharedWeight(b[k], shares[t[k]]);
    }
    if (!(weight > 0.0)) return;
    for (int k = 0; k < 3; ++k) {
        float gain = b[k] * w[k] / weight;
        if (gain == 0.0) continue;
        addToSums(t[k], uniforms.unit, gain * record.impulse.xyz,
                  gain * record.normal.w * record.normal.xyz);
    }
}
