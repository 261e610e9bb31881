// The sums of the blocks of buckets become the place of each block's first entry. One group: each
// thread takes a run of blocks, the runs are summed over the group, and added. Reads and writes
// blocks. A storage barrier follows.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactBlocksBinding) buffer Blocks { uint blocks[]; };

shared uint partial[kGroupSize];

void main() {
    uint self = gl_LocalInvocationID.x;
    uint count = uniforms.bucket_count / kGroupSize;
    uint run = (count + kGroupSize - 1u) / kGroupSize;
    uint first = min(self * run, count);
    uint end = min(first + run, count);
    uint sum = 0u;
    for (uint i = first; i < end; ++i) {
        sum += blocks[i];
    }
    partial[self] = sum;
    for (uint reach = 1u; reach < kGroupSize; reach *= 2u) {
        barrier();
        uint below = self >= reach ? partial[self - reach] : 0u;
        barrier();
        partial[self] += below;
    }
    uint place = partial[self] - sum;
    for (uint i = first; i < end; ++i) {
        uint own = blocks[i];
        blocks[i] = place;
        place += own;
    }
}
