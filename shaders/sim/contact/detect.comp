// Which contacts there are in this substep: of points, and of the edges at them behind those. Reads
// X, d, triangles, normals, candidates, edge pairs. Writes records, what contacts take of each
// vertex, and their number. One thread per listed point. A storage barrier follows, then respond.
#include "buffers.glsl"
#include "answers.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    detectPoint(index);
    detectEdges(index);
}
