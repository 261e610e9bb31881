// Solves each touch of a box and a triangle once (touches.glsl). Reads X (inverse mass), touches,
// shares. Adds to sums. One thread per triangle. A storage barrier follows, then apply.
#include "buffers.glsl"
#include "touches.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < obstacle.triangle_count) respondTriangle(index);
}
