// Solves each contact, of points and of edges, once; with SWEEP_AGAIN from d as it stands. Reads X
// (inverse mass), d, records, shares. Adds to sums, with SWEEP_AGAIN to the impulses of the
// records. One thread per listed point. A storage barrier follows, then apply.
#include "buffers.glsl"
#include "answers.glsl"
#ifndef SWEEP_AGAIN
#define SWEEP_AGAIN false
#endif

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < state.points) respondAt(index, SWEEP_AGAIN);
}
