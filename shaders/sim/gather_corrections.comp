// Adds to each vertex what its bends pull, or with GATHER_ISPCS its ISPCs, in the fixed order of the
// incidence. Reads X (inverse mass), corrections, incidence. Reads and writes d.
// One thread per vertex. A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "constraints.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kDisplacementBinding) uniform samplerBuffer before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement { vec4 displacement[]; };
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer entries;
layout(binding = kCorrectionsBinding) uniform samplerBuffer corrections;
#ifdef GATHER_ISPCS
layout(binding = kConstraintsBinding) uniform usamplerBuffer ispcs;

// On the vertex of the ISPC (slot 0), or on a corner of the triangle that its ray ends on.
vec3 pull(uint ispc, uint slot) {
    vec3 whole = fetch(corrections, ispc).xyz;
    vec2 b = uintBitsToFloat(fetch(ispcs, 2u * ispc + 1u).xy);
    return slot == 0u ? whole : whole * -(slot == 1u ? 1.0 - b.x - b.y : (slot == 2u ? b.x : b.y));
}
#else
// On v0, v1, v2 or v3: see bend.comp.
vec3 pull(uint bend, uint slot) {
    vec4 left = fetch(corrections, 2u * bend);
    vec4 right = fetch(corrections, 2u * bend + 1u);
    if (slot == 0u) return (1.0 - left.w) * left.xyz + (1.0 - right.w) * right.xyz;
    if (slot == 1u) return left.w * left.xyz + right.w * right.xyz;
    return slot == 2u ? -left.xyz : -right.xyz;
}
#endif

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec3 sum = vec3(0.0);
    uvec2 range = fetch(ranges, v).xy;
    for (uint k = range.x; k < range.y; ++k) {
        uint entry = fetch(entries, k).x;
        sum += pull(entry >> 2, entry & 3u);
    }
    float w = uniforms.inverse_density * fetch(positions, v).w;
    displacement[v] = vec4(fetch(before, v).xyz + w * sum, 0.0);
}
