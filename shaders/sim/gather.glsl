// Sums of what the bends or the ISPCs of a vertex pull it with, in the fixed order of their lists,
// which begin at even places and are read by pairs. The includer declares `uniforms`,
// correctionAt(index), and bendEntriesAt(pair) or ispcSharesAt(pair).

vec3 withSum(vec3 d, float inverseUnitMass, vec3 sum) {
    return d + (uniforms.inverse_density * inverseUnitMass) * sum;
}

#ifndef GATHER_ISPCS
// The ends of the edge of a bend answer to the pulls of both triangles.
vec3 endPull(uint entry) {
    vec4 left = correctionAt(entry & ~1u);
    vec4 right = correctionAt(entry | 1u);
    bool atV1 = (entry & 1u) != 0u;
    return (atV1 ? left.w : 1.0 - left.w) * left.xyz + (atV1 ? right.w : 1.0 - right.w) * right.xyz;
}

// Apexes answer to the pull of their own triangle.
vec3 bendSum(BendRange range) {
    vec3 sum = vec3(0.0);
    for (uint k = range.first; k < range.apexes; k += 2u) {
        uvec2 pair = bendEntriesAt(k / 2u);
        sum += endPull(pair.x);
        vec3 second = endPull(pair.y);
        sum += k + 1u < range.apexes ? second : vec3(0.0);
    }
    for (uint k = range.apexes & ~1u; k < range.end; k += 2u) {
        uvec2 pair = bendEntriesAt(k / 2u);
        vec3 first = correctionAt(pair.x).xyz;
        vec3 second = correctionAt(pair.y).xyz;
        sum -= k >= range.apexes ? first : vec3(0.0);
        sum -= k + 1u < range.end ? second : vec3(0.0);
    }
    return sum;
}
#endif

#ifndef GATHER_BENDS
vec3 ispcSum(uvec2 range) {
    vec3 sum = vec3(0.0);
    for (uint k = range.x; k < range.y; k += 2u) {
        IspcSharePair pair = ispcSharesAt(k / 2u);
        sum += pair.first.weight * correctionAt(pair.first.ispc).xyz;
        vec3 second = pair.second.weight * correctionAt(pair.second.ispc).xyz;
        sum += k + 1u < range.y ? second : vec3(0.0);
    }
    return sum;
}
#endif
