// dV/dp of a vertex at X + d: a sixth of the sum of (p_j - p) x (p_k - p) over its triangles. Around
// a closed umbrella this equals the gradient about any origin, and it is small and exact in floats.
// Where triangles are absent it is that of the others about the vertex, and the sum of a third of
// (p - origin) . dV/dp still their exact volume about the origin.
// The includer declares the texels ranges and neighbours (counter-clockwise around each vertex), and
// span(from, to) = p_to - p_from.
vec3 volumeGradient(uint v) {
    vec3 sum = vec3(0.0);
    uvec2 range = fetch(ranges, v).xy;
    vec3 last = span(v, fetch(neighbours, range.y - 1u).x & ~kAfterGap);
    for (uint k = range.x; k < range.y; ++k) {
        uint corner = fetch(neighbours, k).x;
        vec3 next = span(v, corner & ~kAfterGap);
        sum += (corner & kAfterGap) == 0u ? cross(last, next) : vec3(0.0);
        last = next;
    }
    return sum / 6.0;
}
