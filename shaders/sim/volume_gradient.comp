// dV/dp of each vertex: a sixth of the sum of (p_j - p) x (p_k - p) over its triangles. Around a
// closed umbrella this equals the gradient about any origin, and it is small and exact in floats.
// Reads X, d, triangles and their incidence. Writes gradients.
// One thread per vertex. A storage barrier follows, then volume_sum.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kDisplacementBinding) readonly buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kOffsetsBinding) readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = kEntriesBinding) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kGradientsBinding) writeonly buffer Gradients { vec4 gradients[]; };

vec3 relative(uint v, vec3 x, vec3 d) {
    return (positions[v].xyz - x) + (displacement[v].xyz - d);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec3 x = positions[v].xyz;
    vec3 d = displacement[v].xyz;
    vec3 sum = vec3(0.0);
    for (uint k = offsets[v]; k < offsets[v + 1u]; ++k) {
        uvec4 corners = triangles[entries[k] >> 2];
        uint slot = entries[k] & 3u;
        uint following = slot == 0u ? corners.y : (slot == 1u ? corners.z : corners.x);
        uint preceding = slot == 0u ? corners.z : (slot == 1u ? corners.x : corners.y);
        sum += cross(relative(following, x, d), relative(preceding, x, d));
    }
    gradients[v] = vec4(sum / 6.0, 0.0);
}
