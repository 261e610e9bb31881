// Adds to each vertex what the constraints of one type pull it with: TYPE is its number, RANGES and
// ENTRIES declare its lists, SUM sums them up.
// Reads X, corrections, links, lists. Reads and writes d.
// One thread per vertex. A storage barrier follows.
#include "constraints.h"
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};
RECORD_QUADS(kLinksBinding) links;
RANGES(kRangesBinding) ranges;
ENTRIES(kEntriesBinding) entries;
STATE_TEXELS(kCorrectionsBinding) corrections;

#include "sim/mass_split.glsl"

// Sums go in the fixed order of the lists, which begin at even places and are read by pairs.
vec4 correctionAt(uint index) { return fetch(corrections, index); }

// The ends of the edge of a bend answer to the pulls of both triangles.
vec3 endPull(uint entry) {
    vec4 left = correctionAt(entry & ~1u);
    vec4 right = correctionAt(entry | 1u);
    bool atV1 = (entry & 1u) != 0u;
    return (atV1 ? left.w : 1.0 - left.w) * left.xyz + (atV1 ? right.w : 1.0 - right.w) * right.xyz;
}

// Apexes answer to the pull of their own triangle.
vec3 sumOfWingPulls(uint v) {
    BendRange range = bendRangeOf(fetch(ranges, v));
    vec3 sum = vec3(0.0);
    for (uint k = range.first; k < range.apexes; k += 2u) {
        uvec2 pair = fetch(entries, k / 2u).xy;
        sum += endPull(pair.x);
        vec3 second = endPull(pair.y);
        sum += k + 1u < range.apexes ? second : vec3(0.0);
    }
    for (uint k = range.apexes & ~1u; k < range.end; k += 2u) {
        uvec2 pair = fetch(entries, k / 2u).xy;
        vec3 first = correctionAt(pair.x).xyz;
        vec3 second = correctionAt(pair.y).xyz;
        sum -= k >= range.apexes ? first : vec3(0.0);
        sum -= k + 1u < range.end ? second : vec3(0.0);
    }
    return sum;
}

vec3 sumOfShares(uint v) {
    uvec2 range = fetch(ranges, v).xy;
    vec3 sum = vec3(0.0);
    for (uint k = range.x; k < range.y; k += 2u) {
        uvec4 pair = fetch(entries, k / 2u);  // of ConstraintShare
        sum += uintBitsToFloat(pair.y) * correctionAt(pair.x).xyz;
        vec3 second = uintBitsToFloat(pair.w) * correctionAt(pair.z).xyz;
        sum += k + 1u < range.y ? second : vec3(0.0);
    }
    return sum;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec3 sum = SUM(v);
    vec4 x = fetch(positions, v);
    vec3 d = fetch(before, v).xyz + (uniforms.inverse_density * x.w) * sum;
    displacement[v] = vec4(d, splitFrom(TYPE + 1u, x.w, fetch(links, v)));
}
