// The outward normal of a vertex: the sum of its triangles' area vectors over the sum of their
// lengths, so 1 long where the surface is flat and short at tips and at the front of a slit. In w,
// as bits, what its triangles are. The includer declares triangles and their incidence.
vec4 normalOf(uint v, samplerBuffer positions) {
    vec3 sum = vec3(0.0);
    float area = 0.0;
    uint kinds = 0u;
    uvec2 range = fetch(ranges, v).xy;
    for (uint k = range.x; k < range.y; ++k) {
        uvec4 t = fetch(triangles, fetch(incidence, k).x >> 2);
        vec3 a = fetch(positions, t.x).xyz;
        vec3 normal = cross(fetch(positions, t.y).xyz - a, fetch(positions, t.z).xyz - a);
        sum += normal;
        area += length(normal);
        kinds |= (t.w & 1u) != 0u ? kTouchesWall : kTouchesSkin;
    }
    return vec4(area > 0.0 ? sum / area : vec3(0.0), uintBitsToFloat(kinds));
}
