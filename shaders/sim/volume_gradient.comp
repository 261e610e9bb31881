// dV/dp of each vertex at X, and the volume of a block: a third of (p - origin) . dV/dp there,
// since V is homogeneous of degree 3. First each thread over its own vertices, in order, then a
// tree over the group: both orders are fixed.
// Reads X, neighbours, places, pages, pieces, blocks. Writes gradients, volumes of blocks.
// One group of SUM_GROUP threads per block. A storage barrier follows.
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = SUM_GROUP) in;
const uint kSumGroup = SUM_GROUP;

STATE_TEXELS(kPositionsBinding) positions;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) neighbours;
RECORD_WORDS(kPlacesBinding) places;
layout(std430, binding = kPagesBinding) readonly buffer Pages { uint pages[]; };
layout(std430, binding = kGradientsBinding) writeonly buffer Gradients { vec4 gradients[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kBlockSumsBinding) writeonly buffer Volumes { float volumes[]; };

shared float partial[kPageSize];

vec3 positionOf(uint v) { return fetch(positions, v).xyz; }
// Open pieces have no volume constraint, so gaps do not matter here.
uvec2 neighboursAt(uint pair) { return fetch(neighbours, pair).xy & ~kAfterGap; }

// See measure.comp; two neighbours a turn: lists begin at even places.
vec3 sixfoldGradient(vec3 x, uvec2 range) {
    uvec2 pair = neighboursAt(range.x / 2u);
    vec3 first = positionOf(pair.x) - x;
    vec3 last = positionOf(pair.y) - x;
    vec3 sum = cross(first, last);
    for (uint k = range.x + 2u; k < range.y; k += 2u) {
        pair = neighboursAt(k / 2u);
        vec3 next = positionOf(pair.x) - x;
        sum += cross(last, next);
        last = positionOf(k + 1u < range.y ? pair.y : pair.x) - x;
        sum += cross(next, last);
    }
    return sum + cross(last, first);
}

// Of the vertex at a place, if there is one.
float volumeAt(uint place, vec3 origin) {
    uint v = fetch(places, place).x;
    if (v == kNoVertex) return 0.0;
    vec3 x = positionOf(v);
    vec3 sixfold = sixfoldGradient(x, fetch(ranges, v).xy);
    gradients[v].xyz = sixfold / 6.0;
    return dot(x - origin, sixfold) / 18.0;
}

// Over a place of all pages of a block.
float sumOverPages(BlockRecord block, vec3 origin, uint place) {
    float sum = 0.0;
    for (uint i = 0u; i < block.page_count; ++i) {
        sum += volumeAt(kPageSize * pages[block.first_page + i] + place, origin);
    }
    return sum;
}

// To thread 0.
float sumOverPlaces(uint self) {
    for (uint row = self; row < kSumRows; row += kSumGroup) {
        float sum = partial[row];
        for (uint i = row + kSumRows; i < kPageSize; i += kSumRows) sum += partial[i];
        partial[row] = sum;
    }
    barrier();
    float sum = partial[0];
    if (self == 0u) {
        for (uint i = 1u; i < kSumRows; ++i) sum += partial[i];
    }
    return sum;
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    uint self = gl_LocalInvocationID.x;
    vec3 origin = positionOf(pieces[block.piece].origin);
    for (uint place = self; place < kPageSize; place += kSumGroup) {
        partial[place] = sumOverPages(block, origin, place);
    }
    barrier();
    float sum = sumOverPlaces(self);
    if (self == 0u) volumes[gl_WorkGroupID.x] = sum;
}
