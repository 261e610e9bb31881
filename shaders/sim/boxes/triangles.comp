// What of boxes each triangle touches (touches.glsl). Reads X, d, triangles, boxes. Writes touches,
// what they take of each vertex. One thread per triangle. A storage barrier follows, then respond.
#include "buffers.glsl"
#include "touches.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index < obstacle.triangle_count) touchTriangle(index);
}
