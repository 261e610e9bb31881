// Where the entries of each bucket begin: within its block of kGroupSize buckets, and how many the
// block has. Reads counts. Writes starts and the sums of the blocks. One thread per bucket. A
// storage barrier follows, then scan_blocks.
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kContactCountsBinding) readonly buffer Counts { uint counts[]; };
layout(std430, binding = kContactStartsBinding) writeonly buffer Starts { uint starts[]; };
layout(std430, binding = kContactBlocksBinding) writeonly buffer Blocks { uint blocks[]; };

shared uint partial[kGroupSize];

void main() {
    uint self = gl_LocalInvocationID.x;
    uint bucket = gl_GlobalInvocationID.x;
    uint count = counts[bucket];
    partial[self] = count;
    for (uint reach = 1u; reach < kGroupSize; reach *= 2u) {
        barrier();
        uint below = self >= reach ? partial[self - reach] : 0u;
        barrier();
        partial[self] += below;
    }
    starts[bucket] = partial[self] - count;
    if (self == kGroupSize - 1u) {
        blocks[gl_WorkGroupID.x] = partial[self];
    }
}
