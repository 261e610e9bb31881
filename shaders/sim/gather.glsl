// Sums of what the constraints of a vertex pull it with, in the fixed order of their lists, which
// begin at even places and are read by pairs. The includer declares `uniforms`,
// correctionAt(index), and of the list of a type rangeOfList(type, v) and entryOfList(type, index).

vec3 withSum(vec3 d, float inverseUnitMass, vec3 sum) {
    return d + (uniforms.inverse_density * inverseUnitMass) * sum;
}

// The ends of the edge of a bend answer to the pulls of both triangles.
vec3 endPull(uint entry) {
    vec4 left = correctionAt(entry & ~1u);
    vec4 right = correctionAt(entry | 1u);
    bool atV1 = (entry & 1u) != 0u;
    return (atV1 ? left.w : 1.0 - left.w) * left.xyz + (atV1 ? right.w : 1.0 - right.w) * right.xyz;
}

// Apexes answer to the pull of their own triangle.
vec3 sumOfWingPulls(uint type, uint v) {
    BendRange range = bendRangeOf(rangeOfList(type, v));
    vec3 sum = vec3(0.0);
    for (uint k = range.first; k < range.apexes; k += 2u) {
        uvec2 pair = entryOfList(type, k / 2u).xy;
        sum += endPull(pair.x);
        vec3 second = endPull(pair.y);
        sum += k + 1u < range.apexes ? second : vec3(0.0);
    }
    for (uint k = range.apexes & ~1u; k < range.end; k += 2u) {
        uvec2 pair = entryOfList(type, k / 2u).xy;
        vec3 first = correctionAt(pair.x).xyz;
        vec3 second = correctionAt(pair.y).xyz;
        sum -= k >= range.apexes ? first : vec3(0.0);
        sum -= k + 1u < range.end ? second : vec3(0.0);
    }
    return sum;
}

vec3 sumOfShares(uint type, uint v) {
    uvec2 range = rangeOfList(type, v).xy;
    vec3 sum = vec3(0.0);
    for (uint k = range.x; k < range.y; k += 2u) {
        uvec4 pair = entryOfList(type, k / 2u);  // of ConstraintShare
        sum += uintBitsToFloat(pair.y) * correctionAt(pair.x).xyz;
        vec3 second = uintBitsToFloat(pair.w) * correctionAt(pair.z).xyz;
        sum += k + 1u < range.y ? second : vec3(0.0);
    }
    return sum;
}
