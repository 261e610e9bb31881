// Volume and denominator of the volume constraint, summed over the triangles of a block: first
// each thread over its own, in order, then a tree over the group. Both orders are fixed.
// Reads X, d, gradients, triangles and their incidence, pieces, blocks. Writes block sums.
// One group per block. A storage barrier follows, then volume_correct.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kDisplacementBinding) readonly buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kOffsetsBinding) readonly buffer Offsets { uint offsets[]; };
layout(std430, binding = kTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kGradientsBinding) readonly buffer Gradients { vec4 gradients[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kBlockSumsBinding) writeonly buffer Sums { VolumeSum sums[]; };

shared vec2 partial[kGroupSize];

vec3 relative(uint v, vec3 x, vec3 d) {
    return (positions[v].xyz - x) + (displacement[v].xyz - d);
}

// w |dV/dp|^2, shared among the triangles around v.
float stiffnessShare(uint v) {
    vec3 g = gradients[v].xyz;
    float triangleCount = float(offsets[v + 1u] - offsets[v]);
    return uniforms.inverse_density * positions[v].w * dot(g, g) / triangleCount;
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    uint origin = triangles[pieces[block.piece].first_triangle].x;
    vec3 x = positions[origin].xyz;
    vec3 d = displacement[origin].xyz;
    vec2 sum = vec2(0.0);
    for (uint i = gl_LocalInvocationID.x; i < block.triangle_count; i += kGroupSize) {
        uvec4 t = triangles[block.first_triangle + i];
        vec3 normal = cross(relative(t.y, x, d), relative(t.z, x, d));
        sum.x += dot(relative(t.x, x, d), normal) / 6.0;
        sum.y += stiffnessShare(t.x) + stiffnessShare(t.y) + stiffnessShare(t.z);
    }
    partial[gl_LocalInvocationID.x] = sum;
    for (uint span = kGroupSize / 2u; span > 0u; span /= 2u) {
        barrier();
        if (gl_LocalInvocationID.x < span) {
            partial[gl_LocalInvocationID.x] += partial[gl_LocalInvocationID.x + span];
        }
    }
    if (gl_LocalInvocationID.x == 0u) {
        sums[gl_WorkGroupID.x] = VolumeSum(partial[0].x, partial[0].y);
    }
}
