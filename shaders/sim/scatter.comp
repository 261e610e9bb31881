// Writes single words of a buffer. Reads what to write where; writes the buffer. One thread per
// word; no two writes name one word. A storage barrier follows. The buffer may be bound in part,
// from a first word on.
#include "bindings.h"
#include "body_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kWritesBinding) readonly buffer Writes { WordWrite writes[]; };
layout(std430, binding = kWrittenBinding) writeonly buffer Written { uint written[]; };

#include "sim/base/numbers.glsl"

void main() {
    uint firstWrite = numbers.x;
    uint writeCount = numbers.y;
    uint firstWord = numbers.z;
    uint i = gl_GlobalInvocationID.x;
    if (i >= writeCount) return;
    WordWrite write = writes[firstWrite + i];
    written[write.word - firstWord] = write.value;
}
