// dV/dp of a vertex at X + d: a sixth of the sum of (p_j - p) x (p_k - p) over its triangles. Around
// a closed umbrella this equals the gradient about any origin, and it is small and exact in floats.
// The includer declares ranges, neighbours (counter-clockwise around each vertex), and
// span(from, to) = p_to - p_from.
vec3 volumeGradient(uint v) {
    vec3 sum = vec3(0.0);
    uint end = ranges[v].end;
    vec3 last = span(v, neighbours[end - 1u]);
    for (uint k = ranges[v].first; k < end; ++k) {
        vec3 next = span(v, neighbours[k]);
        sum += cross(last, next);
        last = next;
    }
    return sum / 6.0;
}
