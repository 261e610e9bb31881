// dV/dp of each vertex at X (pull_direction.glsl says why), and what the volume constraint sums over a
// block: the volume at X + d, a third of (p - origin) . dV/dp there since V is homogeneous of degree
// 3, and w |dV/dp|^2 at X. First each thread over its own vertices, in order, then a tree over the
// group: both orders are fixed.
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

vec3 spanBefore(uint from, uint to) {
    return fetch(positions, to).xyz - fetch(positions, from).xyz;
}

vec3 motion(uint from, uint to) {
    return fetch(displacement, to).xyz - fetch(displacement, from).xyz;
}

struct GradientPair {
    vec3 before;  // at X
    vec3 now;     // at X + d
};

// Six times the gradient at either, see volume_gradient.glsl.
GradientPair sixfoldGradients(uint v) {
    GradientPair sum = GradientPair(vec3(0.0), vec3(0.0));
    uvec2 range = fetch(ranges, v).xy;
    // Open pieces have no volume constraint, so gaps do not matter here.
    uint corner = fetch(neighbours, range.y - 1u).x & ~kAfterGap;
    vec3 lastBefore = spanBefore(v, corner);
    vec3 last = lastBefore + motion(v, corner);
    for (uint k = range.x; k < range.y; ++k) {
        corner = fetch(neighbours, k).x & ~kAfterGap;
        vec3 nextBefore = spanBefore(v, corner);
        vec3 next = nextBefore + motion(v, corner);
        sum.before += cross(lastBefore, nextBefore);
        sum.now += cross(last, next);
        lastBefore = nextBefore;
        last = next;
    }
    return sum;
}

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
        GradientPair sixfold = sixfoldGradients(v);
        vec3 g = sixfold.before / 6.0;
        gradients[v] = vec4(g, 0.0);
        vec3 arm = spanBefore(origin, v) + motion(origin, v);
        sum += vec2(dot(arm, sixfold.now) / 18.0,
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
