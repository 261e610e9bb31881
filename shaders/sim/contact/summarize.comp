// What a search asks of a bucket before it looks at its triangles: where they lie, which way their
// normals point, of which pieces they are. Reads boxes, starts, blocks, entries. Writes buckets.
// One thread per bucket. A storage barrier follows.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactBoxesBinding) readonly buffer Boxes { ContactBox boxes[]; };
layout(std430, binding = kContactStartsBinding) readonly buffer Starts { uint starts[]; };
layout(std430, binding = kContactBlocksBinding) readonly buffer Blocks { uint blocks[]; };
layout(std430, binding = kContactEntriesBinding) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kContactBucketsBinding) writeonly buffer Buckets {
    ContactBucket buckets[];
};

uint firstEntry(uint bucket) {
    return bucket == uniforms.bucket_count ? uniforms.triangle_count
                                           : blocks[bucket / kGroupSize] + starts[bucket];
}

void main() {
    uint bucket = gl_GlobalInvocationID.x;
    uint first = firstEntry(bucket);
    uint end = firstEntry(bucket + 1u);
    buckets[bucket].directions = 0u;
    buckets[bucket].first = first;
    buckets[bucket].end = end;
    if (first == end) return;
    uint directions = 0u;
    uint firstPiece = 0xffffffffu;
    uint lastPiece = 0u;
    vec3 low = vec3(uintBitsToFloat(0x7f800000u));
    vec3 high = -low;
    for (uint k = first; k < end; ++k) {
        ContactBox box = boxes[entries[k]];
        uint piece = floatBitsToUint(box.high.w) - kFirstBin;
        directions |= 1u << (floatBitsToUint(box.low.w) - kFirstBin);
        firstPiece = min(firstPiece, piece);
        lastPiece = max(lastPiece, piece);
        low = min(low, box.low.xyz);
        high = max(high, box.high.xyz);
    }
    buckets[bucket] = ContactBucket(directions, first, end, firstPiece, lastPiece, low.x, low.y,
                                    low.z, high.x, high.y, high.z);
}
