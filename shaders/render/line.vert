// Lines between pairs of points.
#include "render_bindings.h"
#include "thick_line.glsl"
layout(std430, binding = kBindSegments) readonly buffer Segments { vec4 ends[]; };

void main() {
    int first = 2 * (gl_VertexID / 6);
    gl_Position = lineCorner(ends[first].xyz, ends[first + 1].xyz, gl_VertexID % 6);
}
