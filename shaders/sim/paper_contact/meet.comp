// The pairs of triangles of two pieces that meet, and what each of a pair asks of the other, as the
// paper has it. A pair is found by its smaller triangle (by size of cell, then by number), which
// looks into cells of its own size and larger ones: so each pair is found once, and few cells are
// looked into.
// Reads X, velocities, triangles, boxes of pieces, the grid. Adds to the requests of both, as
// integers, which do not mind the order in which threads come, and to the number of contacts. One
// thread per triangle. A storage barrier follows.
#include "box_records.h"
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactVelocitiesBinding) readonly buffer Velocities {
    vec4 velocities[];
};
layout(std430, binding = kPaperRequestsBinding) buffer Requests { PaperRequest requests[]; };
layout(std430, binding = kPaperPiecesBinding) readonly buffer Bounds { PieceBounds bounds[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactBoxesBinding) readonly buffer Boxes { ContactBox boxes[]; };
layout(std430, binding = kContactBucketsBinding) readonly buffer Buckets {
    ContactBucket buckets[];
};
layout(std430, binding = kContactEntriesBinding) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "sim/numbers.glsl"

#include "response.glsl"
#include "sim/contact/grid.glsl"
#include "sim/ordered_floats.glsl"

// Cells that a search looks into along an axis: boxes are no larger than cells, so three, or four
// where rounding adds one.
const int kMostCells = 4;
// Of a cell: what rounding may put the middle of a box beside it.
const float kRounding = 1e-3;

vec3 lowOf(PieceBounds b) {
    return vec3(orderedFloat(b.low_x), orderedFloat(b.low_y), orderedFloat(b.low_z));
}

vec3 highOf(PieceBounds b) {
    return vec3(orderedFloat(b.high_x), orderedFloat(b.high_y), orderedFloat(b.high_z));
}

vec3 middleOfPiece(uint piece) {
    return 0.5 * (lowOf(bounds[piece]) + highOf(bounds[piece]));
}

bool overlap(vec3 lowA, vec3 highA, vec3 lowB, vec3 highB) {
    return all(lessThanEqual(lowA, highB)) && all(lessThanEqual(lowB, highA));
}

bool meetsOtherPiece(uint piece, vec3 low, vec3 high) {
    bool meets = false;
    for (uint p = 0u; p < numbers.x; ++p) {
        meets = meets || (p != piece && overlap(low, high, lowOf(bounds[p]), highOf(bounds[p])));
    }
    return meets;
}

MovingTriangle triangleAt(uint t) {
    uvec4 corners = triangles[t];
    vec3 velocity = (velocities[corners.x].xyz + velocities[corners.y].xyz +
                     velocities[corners.z].xyz) / 3.0;
    return MovingTriangle(positions[corners.x].xyz, positions[corners.y].xyz,
                          positions[corners.z].xyz, velocity, middleOfPiece(corners.w >> 8));
}

ivec3 inSteps(vec3 way) {
    return ivec3(round(way / uniforms.unit));
}

void ask(uint t, ivec3 loss, ivec3 push) {
    atomicAdd(requests[t].loss_x, loss.x);
    atomicAdd(requests[t].loss_y, loss.y);
    atomicAdd(requests[t].loss_z, loss.z);
    atomicAdd(requests[t].push_x, push.x);
    atomicAdd(requests[t].push_y, push.y);
    atomicAdd(requests[t].push_z, push.z);
    atomicAdd(requests[t].count, 1u);
}

void answer(uint t, uint other) {
    MovingTriangle a = triangleAt(t);
    MovingTriangle b = triangleAt(other);
    if (!intersect(a, b)) return;
    PaperResponse response = responseOf(a, b);
    ivec3 loss = inSteps(response.loss);
    ivec3 push = inSteps(response.push);
    ask(t, loss, push);
    ask(other, -loss, -push);
    atomicAdd(state.contacts, 1u);
}

float longestSide(vec3 low, vec3 high) {
    vec3 extent = high - low;
    return max(extent.x, max(extent.y, extent.z));
}

struct Searcher {
    uint triangle;
    uint piece;
    uint level;
    vec3 low;
    vec3 high;
};

// The cells of one size that a search looks into.
struct Cells {
    ivec3 low;
    ivec3 count;  // along each axis
    uint level;
};

int sizeOf(Cells cells) {
    return cells.count.x * cells.count.y * cells.count.z;
}

uint bucketOfCell(Cells cells, int i) {
    ivec3 count = cells.count;
    ivec3 place = ivec3(i % count.x, (i / count.x) % count.y, i / (count.x * count.y));
    return bucketOf(cells.low + place, cells.level);
}

// Two cells may share a bucket, which counts for the first of them alone.
bool isFirstInItsBucket(Cells cells, int i, uint bucket) {
    int k = 0;
    while (k < i && bucketOfCell(cells, k) != bucket) {
        ++k;
    }
    return k == i;
}

bool isPartner(Searcher self, uint level, uint other) {
    vec3 low = boxes[other].low.xyz;
    vec3 high = boxes[other].high.xyz;
    bool comesAfter = level > self.level || other > self.triangle;
    return comesAfter && overlap(self.low, self.high, low, high) &&
        triangles[other].w >> 8 != self.piece && levelOf(longestSide(low, high)) == level;
}

void searchCell(Searcher self, Cells cells, int i) {
    uint bucket = bucketOfCell(cells, i);
    for (uint k = buckets[bucket].first; k < buckets[bucket].end; ++k) {
        if (isPartner(self, cells.level, entries[k]) && isFirstInItsBucket(cells, i, bucket)) {
            answer(self.triangle, entries[k]);
        }
    }
}

void searchLevel(Searcher self, uint level) {
    float size = cellSize(level);
    float range = 0.5 * min(size, uintBitsToFloat(state.largest[level])) + kRounding * size;
    ivec3 low = ivec3(floor((self.low - range) / size));
    ivec3 count = clamp(ivec3(floor((self.high + range) / size)) - low, 0, kMostCells - 1) + 1;
    Cells cells = Cells(low, count, level);
    for (int i = 0; i < sizeOf(cells); ++i) {
        searchCell(self, cells, i);
    }
}

void main() {
    uint t = gl_GlobalInvocationID.x;
    if (t >= uniforms.triangle_count) return;
    vec3 low = boxes[t].low.xyz;
    vec3 high = boxes[t].high.xyz;
    uint piece = triangles[t].w >> 8;
    if (!meetsOtherPiece(piece, low, high)) return;
    Searcher self = Searcher(t, piece, levelOf(longestSide(low, high)), low, high);
    for (uint level = self.level; level < kGridLevels; ++level) {
        if ((state.levels >> level & 1u) != 0u) {
            searchLevel(self, level);
        }
    }
}
