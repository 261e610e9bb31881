// Writes single words of a buffer. Reads patches; writes the buffer that is being patched. One
// thread per patch; no two patches name one word. A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kPatchesBinding) readonly buffer Patches { WordPatch patches[]; };
layout(std430, binding = kPatchedBinding) writeonly buffer Patched { uint patched[]; };

uniform uint patchCount;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= patchCount) return;
    patched[patches[i].word] = patches[i].value;
}
