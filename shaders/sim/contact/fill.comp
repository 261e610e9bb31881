// Enters each triangle into its bucket. Threads race for the places within a bucket, so nothing may
// hang on their order. Reads homes, starts, blocks. Writes entries; counts go down to zero, where
// the next search wants them. One thread per triangle. A storage barrier follows, then
// summarize.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactHomesBinding) readonly buffer Homes { uint homes[]; };
layout(std430, binding = kContactStartsBinding) readonly buffer Starts { uint starts[]; };
layout(std430, binding = kContactBlocksBinding) readonly buffer Blocks { uint blocks[]; };
layout(std430, binding = kContactCountsBinding) buffer Counts { uint counts[]; };
layout(std430, binding = kContactEntriesBinding) writeonly buffer Entries { uint entries[]; };

void main() {
    uint t = gl_GlobalInvocationID.x;
    if (t >= uniforms.triangle_count) return;
    uint bucket = homes[t];
    uint place = atomicAdd(counts[bucket], 0xffffffffu) - 1u;
    entries[blocks[bucket / kGroupSize] + starts[bucket] + place] = t;
}
