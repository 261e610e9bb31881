// What the edges at a vertex touch: of its pairs of edges the one whose gap ends up smallest. The
// gap is measured along the line across both edges at X, which points to the surface of the vertex;
// both are met where they come nearest to each other at X, so that no torque is left over, and must
// cross there at X + d too. Friction is left to vertices.
// The includer declares `contact` (ContactUniforms), positionOf(v), displacementOf(v).
#include "nearest.glsl"
#include "sim/base/lines.glsl"

STATE_TEXELS(kContactNormalsUnit) contactNormals;
RECORD_WORDS(kContactEdgePairsUnit) contactEdgePairs;

vec3 skinNormalOf(uint v) { return fetch(contactNormals, 2u * v).xyz; }
vec3 wallNormalOf(uint v) { return fetch(contactNormals, 2u * v + 1u).xyz; }
EdgePair edgePairAt(uint place) {
    return EdgePair(fetch(contactEdgePairs, 3u * place).x,
                    fetch(contactEdgePairs, 3u * place + 1u).x,
                    uintBitsToFloat(fetch(contactEdgePairs, 3u * place + 2u).x));
}

struct Crossing {
    uvec4 vertices;
    uint piece;  // of the last two
    vec4 gains;
    vec3 normal;
    float before;  // gap at X [m]
    vec3 slip;
    float lack;  // of the thickness at X + d [m]
    float thickness;
};

bool inside(vec2 where, float end) {
    return all(greaterThanEqual(where, vec2(end))) && all(lessThanEqual(where, vec2(1.0 - end)));
}

// Positions are taken from the first vertex, and d apart from X, which is far larger.
Crossing moreUrgent(Crossing best, uint v, EdgePair pair) {
    uvec4 t = triangleAt(pair.edge >> 2);
    uint corner = pair.edge & 3u;
    uvec4 ends = uvec4(v, pair.other, t[corner], t[(corner + 1u) % 3u]);
    vec3 origin = positionOf(v).xyz;
    vec3 u = positionOf(ends.y).xyz - origin;
    vec3 c = positionOf(ends.z).xyz - origin;
    vec3 w = positionOf(ends.w).xyz - origin - c;
    vec3 third = positionOf(t[(corner + 2u) % 3u]).xyz - origin;
    vec3 face = cross(w, third - c);
    vec3 across = cross(u, w);
    float size = length(across);
    if (size < 0.05 * length(u) * length(w)) return best;
    across *= (dot(across, face) < 0.0 ? -1.0 : 1.0) / size;
    if (dot(across, face) < kAcross * length(face)) return best;
    if (min(dot(across, skinNormalOf(v)), dot(across, wallNormalOf(v))) > kOpposed) return best;
    float before = -dot(across, c);
    vec2 where = nearestOnLines(vec3(0.0), u, c, w);
    vec3 da = displacementOf(ends.x).xyz;
    vec3 db = displacementOf(ends.y).xyz;
    vec3 dc = displacementOf(ends.z).xyz;
    vec3 dd = displacementOf(ends.w).xyz;
    vec2 after = nearestOnLines(da, u + (db - da), c + dc, w + (dd - dc));
    bool isBare = pair.thickness <= kBareEdge * contact.h;
    float end = isBare ? kBareEnd : 0.0;
    if (before < -kEdgeDepth * contact.h || !inside(where, end) || !inside(after, end)) return best;
    vec4 gains = vec4(1.0 - where.x, where.x, where.y - 1.0, -where.y);
    vec3 slip = gains.x * da + gains.y * db + gains.z * dc + gains.w * dd;
    float lack = pair.thickness - before - dot(across, slip);
    // Where rims lie on each other vertices carry, which have friction.
    if (!(lack > best.lack) || (isBare && lack < kHair * contact.h)) return best;
    return Crossing(ends, t.w >> 8, gains, across, before, slip, lack, pair.thickness);
}

// With more lack than `least`; else its lack is that.
Crossing mostUrgent(uint v, float least) {
    Crossing best;
    best.lack = least;
    for (uint k = 0u; k < kEdgePairsPerPoint; ++k) {
        EdgePair pair = edgePairAt(kEdgePairsPerPoint * v + k);
        if (!(pair.thickness > 0.0)) break;
        best = moreUrgent(best, v, pair);
    }
    return best;
}
