// The edges of triangles that the edges at each point may touch until the next search: of all edges
// from the point and all edges of its candidates the kEdgePairsPerPoint nearest pairs, ties by
// their numbers. Only where a thickness is kept: walls of a slit have the same edges on both sides.
// Most pairs are found from several of their ends; respond shares the work among them.
//
// Reads X, the rest shape, triangles, what touches each vertex, candidates. Writes pairs. One
// thread per listed point. A storage barrier follows.
#include "sim/contact/uniforms.glsl"
#include "sim/fetch.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kContactPositionsBinding) uniform samplerBuffer positions;
layout(binding = kContactRestBinding) uniform samplerBuffer restPositions;
layout(binding = kContactTrianglesBinding) uniform usamplerBuffer triangles;
layout(binding = kContactRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kContactRingsBinding) uniform usamplerBuffer rings;
layout(std430, binding = kContactCandidatesBinding) readonly buffer Candidates {
    ContactCandidate candidates[];
};
layout(std430, binding = kContactPointsBinding) readonly buffer Points { uint points[]; };
layout(std430, binding = kContactEdgePairsBinding) writeonly buffer Pairs { EdgePair pairs[]; };
layout(std430, binding = kContactStateBinding) readonly buffer State { ContactState state; };

#include "sim/lines.glsl"

// The best so far, best first.
EdgePair best[kEdgePairsPerPoint];
float bestKey[kEdgePairsPerPoint];
uint found = 0u;

bool comesBefore(EdgePair pair, float key, uint place) {
    if (key != bestKey[place]) return key < bestKey[place];
    if (pair.other != best[place].other) return pair.other < best[place].other;
    return pair.edge < best[place].edge;
}

// Of pairs that are all nearer.
bool isFull(float key) {
    return found == kEdgePairsPerPoint && key > bestKey[found - 1u];
}

void keep(EdgePair pair, float key) {
    if (found == kEdgePairsPerPoint && !comesBefore(pair, key, found - 1u)) return;
    uint place = found < kEdgePairsPerPoint ? found++ : found - 1u;
    while (place > 0u && comesBefore(pair, key, place - 1u)) {
        best[place] = best[place - 1u];
        bestKey[place] = bestKey[place - 1u];
        --place;
    }
    best[place] = pair;
    bestKey[place] = key;
}

// Both triangles of an edge may be candidates; the first one that comes will do: they come in
// order.
bool isKept(uint other, uint from, uint to) {
    for (uint i = 0u; i < found; ++i) {
        uvec4 t = fetch(triangles, best[i].edge >> 2);
        uint corner = best[i].edge & 3u;
        if (best[i].other == other && t[corner] == to && t[(corner + 1u) % 3u] == from) return true;
    }
    return false;
}

// The distance of two segments, from the points of their lines that are nearest to each other.
float distanceOf(vec3 p, vec3 u, vec3 q, vec3 v) {
    vec2 where = clamp(nearestOnLines(p, u, q, v), vec2(0.0), vec2(1.0));
    return length(p + where.x * u - (q + where.y * v));
}

// Of the edges themselves: ends of edges that were one may lie apart.
float thicknessInRest(uint v, uint other, uint from, uint to) {
    vec3 p = fetch(restPositions, v).xyz;
    vec3 q = fetch(restPositions, from).xyz;
    float apart = distanceOf(p, fetch(restPositions, other).xyz - p, q,
                             fetch(restPositions, to).xyz - q);
    return kEdgeThickness * uniforms.thickness * clamp(apart / uniforms.h - 0.5, 0.0, 1.0);
}

void consider(uint v, uint other, ContactCandidate candidate) {
    uvec4 t = fetch(triangles, candidate.triangle);
    if (other == t.x || other == t.y || other == t.z) return;
    vec3 p = fetch(positions, v).xyz;
    vec3 u = fetch(positions, other).xyz - p;
    for (uint i = 0u; i < 3u; ++i) {
        uint from = t[i];
        uint to = t[(i + 1u) % 3u];
        vec3 edge = fetch(positions, to).xyz - fetch(positions, from).xyz;
        if (length(cross(u, edge)) < 0.05 * length(u) * length(edge)) continue;
        float away = distanceOf(p, u, fetch(positions, from).xyz, edge);
        if (!(away <= uniforms.reach) || isFull(away)) continue;
        float thickness = thicknessInRest(v, other, from, to);
        if (thickness > 0.0 && !isKept(other, from, to)) {
            keep(EdgePair(other, 4u * candidate.triangle + i, thickness), away);
        }
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    uint v = points[index];
    for (uint k = 0u; k < kCandidatesPerPoint; ++k) {
        ContactCandidate candidate = candidates[kCandidatesPerPoint * v + k];
        if (candidate.triangle == kNoVertex) break;
        if (!(candidate.thickness > 0.0)) continue;
        uvec2 range = fetch(ranges, v).xy;
        for (uint r = range.x; r < range.y; ++r) {
            uint ring = fetch(rings, r).x;
            consider(v, fetch(triangles, ring >> 2)[((ring & 3u) + 1u) % 3u], candidate);
        }
    }
    uint first = kEdgePairsPerPoint * v;
    for (uint i = 0u; i < found; ++i) {
        pairs[first + i] = best[i];
    }
    if (found < kEdgePairsPerPoint) {
        pairs[first + found] = EdgePair(kNoVertex, 0u, 0.0);
    }
}
