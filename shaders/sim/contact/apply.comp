// Adds to d and X of each vertex what its contacts sum up to; with LAST_SWEEP the substep's contacts
// end. One thread per vertex. A storage barrier follows.
#include "buffers.glsl"
#include "answers.glsl"
#ifndef LAST_SWEEP
#define LAST_SWEEP false
#endif

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (LAST_SWEEP && v == 0u) endContacts();
    if (v < contact.vertex_count) applyTo(v, LAST_SWEEP);
}
