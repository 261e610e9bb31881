// dV/dp of each vertex at X (pull_direction.glsl says why), and what the volume constraint sums
// over a block: the volume at X + d, a third of (p - origin) . dV/dp there since V is homogeneous
// of degree 3, and w |dV/dp|^2 at X. First each thread over its own vertices, in order, then a tree
// over the group: both orders are fixed.
// The block of a piece that finishes last adds the sums of all of them up, in their order, to the
// impulse that brings the piece back to its target volume, as a rigid constraint (alpha = 0).
// Reads X, d, neighbours, places, pages, pieces, blocks. Writes gradients, block sums, impulses.
// One group of SUM_GROUP threads per block. A storage barrier follows, then volume_correct.
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = SUM_GROUP) in;
const uint kSumGroup = SUM_GROUP;

STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) displacement;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) neighbours;
RECORD_WORDS(kPlacesBinding) places;
layout(std430, binding = kPagesBinding) readonly buffer Pages { uint pages[]; };
layout(std430, binding = kGradientsBinding) writeonly buffer Gradients { vec4 gradients[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kBlockSumsBinding) coherent buffer Sums { VolumeSum sums[]; };
layout(std430, binding = kImpulsesBinding) coherent buffer Impulses { VolumeImpulse impulses[]; };

shared vec2 partial[kPageSize];

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return fetch(displacement, v); }
// Open pieces have no volume constraint, so gaps do not matter here.
uvec2 neighboursAt(uint pair) { return fetch(neighbours, pair).xy & ~kAfterGap; }
uvec2 rangeAt(uint v) { return fetch(ranges, v).xy; }
uint placeAt(uint place) { return fetch(places, place).x; }
void setGradient(uint v, vec3 gradient) { gradients[v].xyz = gradient; }
VolumeSum sumOfBlock(uint block) { return sums[block]; }

#include "sim/volume_gradient.glsl"

// Over a place of all pages of a block.
vec2 sumOverPages(BlockRecord block, vec3 originX, vec3 originD, uint place) {
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < block.page_count; ++i) {
        sum += sumAt(kPageSize * pages[block.first_page + i] + place, originX, originD);
    }
    return sum;
}

// To thread 0.
vec2 sumOverPlaces(uint self) {
    for (uint row = self; row < kSumRows; row += kSumGroup) {
        vec2 sum = partial[row];
        for (uint i = row + kSumRows; i < kPageSize; i += kSumRows) sum += partial[i];
        partial[row] = sum;
    }
    barrier();
    vec2 sum = partial[0];
    if (self == 0u) {
        for (uint i = 1u; i < kSumRows; ++i) sum += partial[i];
    }
    return sum;
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    uint self = gl_LocalInvocationID.x;
    uint origin = pieces[block.piece].origin;
    vec3 originX = positionOf(origin).xyz;
    vec3 originD = displacementOf(origin).xyz;
    for (uint place = self; place < kPageSize; place += kSumGroup) {
        partial[place] = sumOverPages(block, originX, originD, place);
    }
    barrier();
    vec2 sum = sumOverPlaces(self);
    if (self == 0u) {
        sums[gl_WorkGroupID.x] = VolumeSum(sum.x, sum.y);
        memoryBarrierBuffer();
        if (atomicAdd(impulses[block.piece].finished, 1u) + 1u == pieces[block.piece].block_count) {
            memoryBarrierBuffer();
            impulses[block.piece] = VolumeImpulse(impulseOver(pieces[block.piece]), 0u);
        }
    }
}
