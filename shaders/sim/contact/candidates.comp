// The triangles that each vertex may touch until the next search: the kCandidatesPerPoint nearest
// ones, in proportion to how far the pair can move, ties by their index. So the result does not
// hang on the order in which the tree yields them. And the edges that its own may touch.
//
// Within a piece a vertex touches the opposite wall of a slit, or what is far away in the rest
// shape, as another arm; never the material around it or behind it.
//
// Each vertex looks through the leaves near its group that are near itself. What is near hangs on
// how fast the two approach each other, so what moves fast elsewhere costs nothing.
//
// Reads X, velocities, rest shape, normals, the tree, the order of vertices, triangles and their
// incidence. Writes candidates, pairs of edges, the list of points with any and its length. One
// thread per place in the order. A storage and a command barrier follow.
#include "sim/contact/uniforms.glsl"
#include "sim/base/fetch.glsl"
layout(local_size_x = kSearchGroup) in;
layout(binding = kContactPositionsBinding) uniform samplerBuffer positions;
layout(binding = kContactVelocitiesBinding) uniform samplerBuffer velocities;
layout(binding = kContactRestBinding) uniform samplerBuffer restPositions;
layout(binding = kContactTrianglesBinding) uniform usamplerBuffer triangles;
layout(binding = kContactNormalsBinding) uniform samplerBuffer normals;
layout(binding = kContactRestNormalsBinding) uniform samplerBuffer restNormals;
layout(binding = kContactBoxesBinding) uniform usamplerBuffer boxes;
layout(binding = kContactNodesBinding) uniform usamplerBuffer nodes;
layout(binding = kContactOrderBinding) uniform usamplerBuffer order;
layout(binding = kContactRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kContactIncidenceBinding) uniform usamplerBuffer incidence;
layout(std430, binding = kContactLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kContactPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kContactCandidatesBinding) writeonly buffer Candidates {
    ContactCandidate candidates[];
};
layout(std430, binding = kContactEdgePairsBinding) writeonly buffer Pairs { EdgePair pairs[]; };
layout(std430, binding = kContactPointsBinding) writeonly buffer Points { uint points[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "closest_point.glsl"
#include "directions.glsl"
#include "sim/base/numbers.glsl"
#include "tree.glsl"

// Further than any triangle that moves so fast against a vertex is a candidate.
float rangeAt(float speed) {
    return min(uniforms.margin, uniforms.reach + uniforms.interval * speed);
}

#include "tree_search.glsl"

// The best so far, best first.
uint bestTriangle[kCandidatesPerPoint];
float bestThickness[kCandidatesPerPoint];
float bestKey[kCandidatesPerPoint];
uint found = 0u;

bool comesBefore(float key, uint t, uint place) {
    return key < bestKey[place] || (key == bestKey[place] && t < bestTriangle[place]);
}

void keep(uint t, float key, float thickness) {
    if (found == kCandidatesPerPoint && !comesBefore(key, t, found - 1u)) return;
    uint place = found < kCandidatesPerPoint ? found++ : found - 1u;
    while (place > 0u && comesBefore(key, t, place - 1u)) {
        bestKey[place] = bestKey[place - 1u];
        bestTriangle[place] = bestTriangle[place - 1u];
        bestThickness[place] = bestThickness[place - 1u];
        --place;
    }
    bestKey[place] = key;
    bestTriangle[place] = t;
    bestThickness[place] = thickness;
}

// Whether one of two normals opposes that of a triangle, of any length.
bool opposes(vec3 skin, vec3 wall, vec3 normal) {
    return min(dot(skin, normal), dot(wall, normal)) < kOpposed * length(normal);
}

// How a vertex lies to a triangle in the rest shape.
struct RestPlace {
    float separation;  // [m]
    float height;      // above the triangle's plane [m]
    float size;        // longest edge of the triangle [m]
    bool opposed;      // the normals are
};

RestPlace placeInRest(uvec4 t) {
    vec3 p = fetch(restPositions, self.vertex).xyz;
    vec3 a = fetch(restPositions, t.x).xyz - p;
    vec3 b = fetch(restPositions, t.y).xyz - p;
    vec3 c = fetch(restPositions, t.z).xyz - p;
    vec3 normal = cross(b - a, c - a);
    normal /= max(length(normal), 1e-30);
    vec3 weights = closestWeights(a, b, c);
    return RestPlace(length(weights.x * a + weights.y * b + weights.z * c), -dot(normal, a),
                     max(length(b - a), max(length(c - b), length(a - c))),
                     opposes(fetch(restNormals, 2u * self.vertex).xyz,
                             fetch(restNormals, 2u * self.vertex + 1u).xyz, normal));
}

// Of a vertex and a triangle of the same piece.
bool mayTouch(uvec4 t, RestPlace rest) {
    if (rest.separation < kNearInRest * max(uniforms.h, rest.size)) {
        bool walls = (t.w & 1u) != 0u && (self.kinds & kTouchesWall) != 0u;
        return walls && rest.opposed && rest.height >= -kSlabDepth * uniforms.h;
    }
    bool throughArm = rest.opposed && rest.height < -0.5 * rest.separation &&
        rest.separation < kArmWidth * uniforms.h;
    return !throughArm;
}

// None across a slit, so that nothing is pushed apart where a cut has just been made.
float thicknessAt(float separation) {
    return uniforms.thickness * clamp(separation / uniforms.h - 0.5, 0.0, 1.0);
}

// Whether what lies so deep in a triangle has come through its wall from the other side, or rests
// there: it is for the triangles there to stop it.
bool comesFromBehind(uvec4 t, vec3 weights, float depth) {
    if (!(depth > 0.0)) return false;
    float wall = weights.x * fetch(restNormals, 2u * t.x).w;
    wall += weights.y * fetch(restNormals, 2u * t.y).w;
    wall += weights.z * fetch(restNormals, 2u * t.z).w;
    return depth > kDeepInWall * wall;
}

void consider(uint index) {
    uvec4 t = fetch(triangles, index);
    uint v = self.vertex;
    if (t.x == v || t.y == v || t.z == v) return;
    vec3 a = fetch(positions, t.x).xyz - self.place;
    vec3 b = fetch(positions, t.y).xyz - self.place;
    vec3 c = fetch(positions, t.z).xyz - self.place;
    vec3 normal = cross(b - a, c - a);
    if (!opposes(self.skin, self.wall, normal)) return;
    vec3 speed = self.velocity - (fetch(velocities, t.x).xyz + fetch(velocities, t.y).xyz +
                                  fetch(velocities, t.z).xyz) / 3.0;
    float range = min(uniforms.margin, uniforms.reach + uniforms.interval * length(speed));
    vec3 weights = closestWeights(a, b, c);
    float away = length(weights.x * a + weights.y * b + weights.z * c);
    if (!(away <= range) || comesFromBehind(t, weights, dot(normal, a) / length(normal))) return;
    RestPlace rest = placeInRest(t);
    if (t.w >> 8 == self.piece && !mayTouch(t, rest)) return;
    keep(index, away / range, thicknessAt(rest.separation));
}

// --- What lies near -----------------------------------------------------------------------------

// Of the range: what floats may say of a box's distance against the triangle's.
const float kBoxSlack = 0.01;

// Where a branch costs as much as both of its sides, a loop that ends early is what saves work: so
// nodes that are near the vertex are listed first, then the triangles in them that are.
const uint kMostListed = 8u;
uint listed[kMostListed];
uint listedCount;
const uint kMostPending = kTreeFan * kMostListed;
uint pending[kMostPending];
uint waiting;

void look(uint place, float range) {
    uvec4 low = fetch(boxes, 2u * place);
    uvec4 high = fetch(boxes, 2u * place + 1u);
    vec3 apart = max(max(uintBitsToFloat(low.xyz) - self.place,
                         self.place - uintBitsToFloat(high.xyz)), vec3(0.0));
    if ((self.opposed >> low.w & 1u) != 0u && dot(apart, apart) <= range) {
        pending[waiting] = high.w;
        ++waiting;
    }
}

void lookThroughListed(inout Bounds own) {
    waiting = 0u;
    for (uint i = 0u; i < listedCount; ++i) {
        uint leaf = listed[i];
        float range = squareOfRange(own, leaf) * own.share * own.share;
        for (uint child = 0u; child < kTreeFan; ++child) {
            look(kTreeFan * leaf + child, range);
        }
    }
    for (uint i = 0u; i < waiting; ++i) {
        consider(pending[i]);
    }
    if (found == kCandidatesPerPoint) {
        own.share = min(1.0, bestKey[found - 1u] + kBoxSlack);
    }
}

void lookThroughLeaves(inout Bounds own) {
    uint next = 0u;
    uint end = own.opposed != 0u ? leafCount : 0u;
    while (next < end) {
        listedCount = 0u;
        for (; next < end && listedCount < kMostListed; ++next) {
            uvec2 leaf = leafAt(next);
            if (isWithin(own, leaf.x, uintBitsToFloat(leaf.y) * own.share * own.share)) {
                listed[listedCount] = leaf.x;
                ++listedCount;
            }
        }
        lookThroughListed(own);
    }
}

#include "edge_pairs.glsl"

bool findsEdges = numbers.z != 0u;

void main() {
    takeVertex();
    Bounds own = ownBounds();
    Bounds group = boundsOfGroup(own);
    search(own, group);
    uint v = self.vertex;
    uint first = kCandidatesPerPoint * v;
    if (found == 0u) {
        if (v < uniforms.vertex_count) candidates[first] = ContactCandidate(kNoVertex, 0.0);
        return;
    }
    for (uint i = 0u; i < found; ++i) {
        candidates[first + i] = ContactCandidate(bestTriangle[i], bestThickness[i]);
    }
    if (found < kCandidatesPerPoint) {
        candidates[first + found] = ContactCandidate(kNoVertex, 0.0);
    }
    if (findsEdges) findEdgePairs();
    uint place = atomicAdd(state.points, 1u);
    points[place] = v;
    atomicMax(state.point_groups, place / kGroupSize + 1u);
    atomicMax(state.vertex_groups, (uniforms.vertex_count + kGroupSize - 1u) / kGroupSize);
}
