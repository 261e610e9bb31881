// One quad between each pose of the blade and the next.
#include "render_bindings.h"
layout(std430, binding = kBindSegments) readonly buffer Poses { vec4 ends[]; };
uniform mat4 viewProjection;

void main() {
    const int corners[6] = int[](0, 1, 2, 2, 1, 3);
    int first = 2 * (gl_VertexID / 6);
    gl_Position = viewProjection * vec4(ends[first + corners[gl_VertexID % 6]].xyz, 1);
}
