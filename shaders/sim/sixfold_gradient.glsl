// dV/dp of a vertex: a sixth of the sum of (p_j - p) x (p_k - p) over its triangles. Around a
// closed umbrella this equals the gradient about any origin, and it is small and exact in floats.
// Where triangles are absent it is that of the others about the vertex, and the sum of a third of
// (p - origin) . dV/dp still their exact volume about the origin. The includer declares
// positionOf(v) and neighbourAt(place): counter-clockwise around each vertex, with kAfterGap.

// Six times the gradient, of the vertex at x with neighbours at `range`.
vec3 sixfoldGradient(vec3 x, uvec2 range) {
    vec3 sum = vec3(0.0);
    vec3 last = positionOf(neighbourAt(range.y - 1u) & ~kAfterGap).xyz - x;
    for (uint k = range.x; k < range.y; ++k) {
        uint corner = neighbourAt(k);
        vec3 next = positionOf(corner & ~kAfterGap).xyz - x;
        sum += (corner & kAfterGap) == 0u ? cross(last, next) : vec3(0.0);
        last = next;
    }
    return sum;
}
