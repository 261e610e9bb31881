// Sums of what the bends or the ISPCs of a vertex pull it with, in the fixed order of their lists.
// The includer declares `uniforms`, correctionAt(index), and bendEntryAt(place) or ispcShareAt(place).

vec3 withSum(vec3 d, float inverseUnitMass, vec3 sum) {
    return d + (uniforms.inverse_density * inverseUnitMass) * sum;
}

#ifndef GATHER_ISPCS
// Apexes of a bend answer to the pull of their own triangle, the ends of its edge to both.
vec3 bendSum(BendRange range) {
    vec3 sum = vec3(0.0);
    for (uint k = range.first; k < range.apexes; ++k) {
        uint entry = bendEntryAt(k);
        vec4 left = correctionAt(entry & ~1u);
        vec4 right = correctionAt(entry | 1u);
        bool atV1 = (entry & 1u) != 0u;
        sum += (atV1 ? left.w : 1.0 - left.w) * left.xyz + (atV1 ? right.w : 1.0 - right.w) * right.xyz;
    }
    for (uint k = range.apexes; k < range.end; ++k) {
        sum -= correctionAt(bendEntryAt(k)).xyz;
    }
    return sum;
}
#endif

#ifndef GATHER_BENDS
vec3 ispcSum(uvec2 range) {
    vec3 sum = vec3(0.0);
    for (uint k = range.x; k < range.y; ++k) {
        IspcShare share = ispcShareAt(k);
        sum += share.weight * correctionAt(share.ispc).xyz;
    }
    return sum;
}
#endif
