// Adds to d and X of each vertex what its touches sum up to (touches.glsl). One thread per vertex.
// A storage barrier follows.
#include "buffers.glsl"
#include "touches.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v < obstacle.vertex_count) applyTouches(v);
}
