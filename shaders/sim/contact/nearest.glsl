// Which of its candidates a vertex comes nearest to, at X + d. The includer declares
// positionOf(v), displacementOf(v).
#include "contact_bindings.h"
#include "closest_point.glsl"
#include "sim/base/fetch.glsl"

RECORD_QUADS(kContactTrianglesUnit) contactTriangles;
RECORD_PAIRS(kContactCandidatesUnit) contactCandidates;

uvec4 triangleAt(uint t) { return fetch(contactTriangles, t); }
ContactCandidate candidateAt(uint place) {
    uvec2 words = fetch(contactCandidates, place).xy;
    return ContactCandidate(words.x, uintBitsToFloat(words.y));
}

struct Nearest {
    uvec4 triangle;
    vec3 offset;      // from the closest point to the vertex [m]
    vec3 areaNormal;  // not of unit length
    vec3 weights;     // of that point
    float thickness;
};

// Differences of positions and of displacements are taken apart, since d is far smaller than X.
vec3 span(vec3 x, vec3 d, uint to) {
    return (positionOf(to).xyz - x) + (displacementOf(to).xyz - d);
}

Nearest nearest(uint v) {
    // Where there are none, or all is NaN.
    Nearest best = Nearest(uvec4(0u), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
    float least = 1e30;
    vec3 x = positionOf(v).xyz;
    vec3 d = displacementOf(v).xyz;
    for (uint k = 0u; k < kCandidatesPerPoint; ++k) {
        ContactCandidate candidate = candidateAt(kCandidatesPerPoint * v + k);
        if (candidate.triangle == kNoVertex) break;
        uvec4 t = triangleAt(candidate.triangle);
        vec3 a = span(x, d, t.x);
        vec3 b = span(x, d, t.y);
        vec3 c = span(x, d, t.z);
        vec3 weights = closestWeights(a, b, c);
        vec3 offset = -(weights.x * a + weights.y * b + weights.z * c);
        float away = dot(offset, offset);
        if (away < kNearerBy * least) {
            least = away;
            best = Nearest(t, offset, cross(b - a, c - a), weights, candidate.thickness);
        }
    }
    return best;
}

// How far beside the triangle the vertex comes to lie [m].
float lateralDistance(Nearest near) {
    vec3 normal = near.areaNormal / max(length(near.areaNormal), 1e-30);
    return length(near.offset - dot(normal, near.offset) * normal);
}
