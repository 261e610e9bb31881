// Adds to d and X of each vertex what its contacts sum up to; with LAST_SWEEP the contacts of the
// substep end. One thread per vertex. A storage barrier follows.
#include "buffers.glsl"
#include "answers.glsl"
#ifndef LAST_SWEEP
#define LAST_SWEEP false
#endif

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (LAST_SWEEP && v == 0u) endContacts();
    uint share = v < contact.vertex_count ? shareTaken(v) : 0u;
    // A loop, which llvmpipe skips where none of eight threads has a contact.
    for (uint once = share != 0u ? 1u : 0u; once > 0u; --once) applyTo(v, LAST_SWEEP);
}
