// Lines of constant width in pixels: each segment becomes a quad with a feather of one pixel.
#include "render_bindings.h"
layout(std430, binding = kBindSegments) readonly buffer Segments { vec4 ends[]; };
uniform mat4 viewProjection;
uniform vec2 viewport;  // [px]
uniform float width;    // [px]
noperspective out float across;

// Moves `a` along the segment until it lies in front of the eye.
vec4 clipped(vec4 a, vec4 b) {
    const float kNear = 1e-4;
    return a.w >= kNear || b.w <= a.w ? a : mix(a, b, (kNear - a.w) / (b.w - a.w));
}

void main() {
    int first = 2 * (gl_VertexID / 6);
    int corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
    vec4 p = viewProjection * vec4(ends[first].xyz, 1);
    vec4 q = viewProjection * vec4(ends[first + 1].xyz, 1);
    vec4 a = clipped(p, q);
    vec4 b = clipped(q, p);
    vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
    float size = length(along);
    along = size > 1e-6 ? along / size : vec2(1, 0);
    float reach = 0.5 * width + 1.0;
    across = (corner & 1) == 0 ? -reach : reach;
    vec4 end = corner < 2 ? a : b;
    vec2 offset = vec2(-along.y, along.x) * across * 2.0 / viewport;
    gl_Position = end + vec4(offset * end.w, -2e-4 * end.w, 0);
}
