// A line of constant width in pixels: a quad of two triangles with a feather of one pixel.
uniform mat4 viewProjection;
uniform vec2 viewport;  // [px]
uniform float width;    // [px]
noperspective out float across;

// Moves `a` along the segment onto the near plane, if that parts them: at any size of the scene.
vec4 clipped(vec4 a, vec4 b) {
    float before = a.z + a.w;
    float after = b.z + b.w;
    return before >= 0.0 || after <= 0.0 ? a : mix(a, b, before / (before - after));
}

// The corner (0 to 5) of the line from p to q.
vec4 lineCorner(vec3 from, vec3 to, int index) {
    int corner = int[](0, 1, 2, 2, 1, 3)[index];
    vec4 p = viewProjection * vec4(from, 1);
    vec4 q = viewProjection * vec4(to, 1);
    vec4 a = clipped(p, q);
    vec4 b = clipped(q, p);
    vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
    float size = length(along);
    along = size > 1e-6 ? along / size : vec2(1, 0);
    float reach = 0.5 * width + 1.0;
    across = (corner & 1) == 0 ? -reach : reach;
    vec4 end = corner < 2 ? a : b;
    vec2 offset = vec2(-along.y, along.x) * across * 2.0 / viewport;
    return end + vec4(offset * end.w, -2e-4 * end.w, 0);
}
