// The edges of triangles that the edges at each point may touch until the next search: of all edges
// from the point and all edges of its candidates the kEdgePairsPerPoint nearest pairs, ties by
// their numbers. Only where a thickness is kept: walls of a slit have the same edges on both sides;
// and at rims against other pieces, where those slide over each other.
// Most pairs are found from several of their ends; respond shares the work among them. Part of
// candidates.comp.
#include "sim/base/lines.glsl"

// The best so far, best first.
EdgePair bestPairs[kEdgePairsPerPoint];
float pairKeys[kEdgePairsPerPoint];
uint pairsFound = 0u;

bool pairComesBefore(EdgePair pair, float key, uint place) {
    if (key != pairKeys[place]) return key < pairKeys[place];
    if (pair.other != bestPairs[place].other) return pair.other < bestPairs[place].other;
    return pair.edge < bestPairs[place].edge;
}

// Of pairs that are all nearer.
bool isFull(float key) {
    return pairsFound == kEdgePairsPerPoint && key > pairKeys[pairsFound - 1u];
}

void keepPair(EdgePair pair, float key) {
    if (pairsFound == kEdgePairsPerPoint && !pairComesBefore(pair, key, pairsFound - 1u)) return;
    uint place = pairsFound < kEdgePairsPerPoint ? pairsFound++ : pairsFound - 1u;
    while (place > 0u && pairComesBefore(pair, key, place - 1u)) {
        bestPairs[place] = bestPairs[place - 1u];
        pairKeys[place] = pairKeys[place - 1u];
        --place;
    }
    bestPairs[place] = pair;
    pairKeys[place] = key;
}

// Both triangles of an edge may be candidates; the first one that comes will do: they come in
// order.
bool isKept(uint other, uint from, uint to) {
    for (uint i = 0u; i < pairsFound; ++i) {
        uvec4 t = fetch(triangles, bestPairs[i].edge >> 2);
        uint corner = bestPairs[i].edge & 3u;
        if (bestPairs[i].other != other) continue;
        if (t[corner] == to && t[(corner + 1u) % 3u] == from) return true;
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

void considerEdges(uint other, uint triangle) {
    uvec4 t = fetch(triangles, triangle);
    if (other == t.x || other == t.y || other == t.z) return;
    vec3 p = self.place;
    vec3 u = fetch(positions, other).xyz - p;
    for (uint i = 0u; i < 3u; ++i) {
        uint from = t[i];
        uint to = t[(i + 1u) % 3u];
        vec3 edge = fetch(positions, to).xyz - fetch(positions, from).xyz;
        if (length(cross(u, edge)) < 0.05 * length(u) * length(edge)) continue;
        float away = distanceOf(p, u, fetch(positions, from).xyz, edge);
        if (!(away <= uniforms.reach) || isFull(away)) continue;
        float thickness = thicknessInRest(self.vertex, other, from, to);
        if (t.w >> 8 != self.piece) thickness = max(thickness, kBareEdge * uniforms.h);
        if (thickness > 0.0 && !isKept(other, from, to)) {
            keepPair(EdgePair(other, 4u * triangle + i, thickness), away);
        }
    }
}

void findEdgePairs() {
    uint v = self.vertex;
    uvec2 range = fetch(ranges, v).xy;
    bool atRim = self.kinds == (kTouchesSkin | kTouchesWall);
    for (uint k = 0u; k < found; ++k) {
        bool isOther = fetch(triangles, bestTriangle[k]).w >> 8 != self.piece;
        if (!(bestThickness[k] > 0.0) && !(atRim && isOther)) continue;
        for (uint r = range.x; r < range.y; ++r) {
            uint ring = fetch(incidence, r).x;
            considerEdges(fetch(triangles, ring >> 2)[((ring & 3u) + 1u) % 3u], bestTriangle[k]);
        }
    }
    uint first = kEdgePairsPerPoint * v;
    for (uint i = 0u; i < pairsFound; ++i) {
        pairs[first + i] = bestPairs[i];
    }
    if (pairsFound < kEdgePairsPerPoint) {
        pairs[first + pairsFound] = EdgePair(kNoVertex, 0u, 0.0);
    }
}
