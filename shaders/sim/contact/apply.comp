// Adds to d and X of each vertex what its contacts sum up to, and ends the contacts of the substep.
// One thread per vertex. A storage barrier follows.
#include "buffers.glsl"
#include "answers.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v == 0u) endContacts();
    uint share = v < contact.vertex_count ? shareTaken(v) : 0u;
    // A loop, which llvmpipe skips where none of eight threads has a contact.
    for (uint once = share != 0u ? 1u : 0u; once > 0u; --once) applyTo(v);
}
