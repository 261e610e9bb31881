// Solves each contact, of points and of edges, once; with SWEEP_AGAIN from d as the first time
// leaves it. Reads X (inverse mass), d, records, shares. Adds to sums, with SWEEP_AGAIN to the
// impulses of the records. One thread per listed point. A storage barrier follows, then
// SWEEP_AGAIN or apply.
#include "buffers.glsl"
#include "answers.glsl"
#ifndef SWEEP_AGAIN
#define SWEEP_AGAIN false
#endif

// Loops, which llvmpipe skips where none of eight threads has a contact; it runs all branches.
void respondIfTouching(uint place, float friction) {
    for (uint once = records[place].v1 != kNoVertex ? 1u : 0u; once > 0u; --once) {
        respondOne(place, friction, SWEEP_AGAIN);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    respondIfTouching(index, contact.friction);
    respondIfTouching(state.points + index, 0.0);
}
