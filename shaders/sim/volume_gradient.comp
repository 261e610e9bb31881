// dV/dp of each vertex, and what the volume constraint sums of it over a block: the volume, a third
// of (p - origin) . dV/dp since V is homogeneous of degree 3, and w |dV/dp|^2. First each thread
// over its own vertices, in order, then a tree over the group: both orders are fixed.
// The block of a piece that finishes last adds the sums of all of them up, in their order, to the
// impulse that brings the piece back to its target volume, as a rigid constraint (alpha = 0).
// Reads X, d, neighbours, places, pages, pieces, blocks. Writes gradients, block sums, impulses.
// One group per block. A storage barrier follows, then volume_correct.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kDisplacementBinding) uniform samplerBuffer displacement;
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer neighbours;
layout(binding = kPlacesBinding) uniform usamplerBuffer places;
layout(std430, binding = kPagesBinding) readonly buffer Pages { uint pages[]; };
layout(std430, binding = kGradientsBinding) writeonly buffer Gradients { vec4 gradients[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kBlockSumsBinding) coherent buffer Sums { VolumeSum sums[]; };
layout(std430, binding = kImpulsesBinding) coherent buffer Impulses { VolumeImpulse impulses[]; };

shared vec2 partial[kGroupSize];

vec3 span(uint from, uint to) {
    return (fetch(positions, to).xyz - fetch(positions, from).xyz) +
        (fetch(displacement, to).xyz - fetch(displacement, from).xyz);
}

#include "sim/volume_gradient.glsl"

float impulseOf(PieceRecord piece) {
    float volume = 0.0;
    float denominator = 0.0;
    for (uint k = 0u; k < piece.block_count; ++k) {
        volume += sums[piece.first_block + k].volume;
        denominator += sums[piece.first_block + k].denominator;
    }
    bool holds = piece.constrained != 0u && denominator > 0.0;
    return holds ? -(volume - piece.target_volume) / denominator : 0.0;
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    uint origin = pieces[block.piece].origin;
    uint self = gl_LocalInvocationID.x;
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < block.page_count; ++i) {
        uint v = fetch(places, kPageSize * pages[block.first_page + i] + self).x;
        if (v == kNoVertex) continue;
        vec3 g = volumeGradient(v);
        gradients[v] = vec4(g, 0.0);
        sum += vec2(dot(span(origin, v), g) / 3.0,
                    uniforms.inverse_density * fetch(positions, v).w * dot(g, g));
    }
    partial[self] = sum;
    for (uint reach = kGroupSize / 2u; reach > 0u; reach /= 2u) {
        barrier();
        if (self < reach) {
            partial[self] += partial[self + reach];
        }
    }
    if (self == 0u) {
        sums[gl_WorkGroupID.x] = VolumeSum(partial[0].x, partial[0].y);
        memoryBarrierBuffer();
        if (atomicAdd(impulses[block.piece].finished, 1u) + 1u == pieces[block.piece].block_count) {
            memoryBarrierBuffer();
            impulses[block.piece] = VolumeImpulse(impulseOf(pieces[block.piece]), 0u);
        }
    }
}
