// What a search for contacts needs: the tree of boxes over triangles, and the normals of vertices.
// Each group fits as many nodes of the lowest level as it has threads, and those above them; the
// group that is done last fits the levels further up.
//
// Reads X, velocities, rest shape, triangles and their incidence, pieces, the order of triangles.
// Writes boxes, nodes and normals, those of the rest shape too if it is new, and starts the counts
// of a search anew. One thread per vertex or, where there are more, node of the lowest level. A
// storage barrier follows.
#include "sim/contact/uniforms.glsl"
#include "sim/base/fetch.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kContactPositionsBinding) uniform samplerBuffer positions;
layout(binding = kContactVelocitiesBinding) uniform samplerBuffer velocities;
layout(binding = kContactRestBinding) uniform samplerBuffer restPositions;
layout(binding = kContactTrianglesBinding) uniform usamplerBuffer triangles;
layout(binding = kContactOrderBinding) uniform usamplerBuffer order;
layout(binding = kContactRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kContactIncidenceBinding) uniform usamplerBuffer incidence;
layout(binding = kContactColumnsBinding) uniform usamplerBuffer columns;
layout(binding = kContactColumnRangesBinding) uniform usamplerBuffer columnRanges;
layout(binding = kContactColumnSharesBinding) uniform usamplerBuffer columnShares;
layout(std430, binding = kContactNormalsBinding) writeonly buffer Normals { vec4 normals[]; };
layout(std430, binding = kContactRestNormalsBinding) writeonly buffer RestNormals {
    vec4 restNormals[];
};
layout(std430, binding = kContactPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kContactBoxesBinding) writeonly buffer Boxes { uvec4 boxes[]; };
layout(std430, binding = kContactNodesBinding) coherent buffer Nodes { uvec4 nodes[]; };
layout(std430, binding = kContactStateBinding) coherent buffer State { ContactState state; };

#include "directions.glsl"
#include "normals.glsl"
#include "sim/base/numbers.glsl"
#include "tree.glsl"

uint leaves = numbers.x;        // nodes of the lowest level
uint vertices = numbers.y;      // whose normals are wanted
uint restVertices = numbers.z;  // and those of the rest shape

void startAnew() {
    state.point_groups = 0u;
    state.point_groups_y = 1u;
    state.point_groups_z = 1u;
    state.vertex_groups = 0u;
    state.vertex_groups_y = 1u;
    state.vertex_groups_z = 1u;
    state.points = 0u;
    state.contacts = 0u;
    state.last_contacts = 0u;
}

void writeNode(uint i, TreeNode node) {
    nodes[4u * i] = uvec4(floatBitsToUint(node.low), node.directions);
    nodes[4u * i + 1u] = uvec4(floatBitsToUint(node.high), node.firstChild);
    nodes[4u * i + 2u] = uvec4(floatBitsToUint(node.slowest), node.firstPiece);
    nodes[4u * i + 3u] = uvec4(floatBitsToUint(node.fastest), node.lastPiece);
}

uint binOfTriangle(vec3 a, vec3 b, vec3 c, uint piece) {
    vec3 normal = cross(b - a, c - a);
    bool touches = dot(normal, normal) > 0.0 && pieces[piece].constrained != 0u;  // no chip
    return touches ? binOf(normal) : kNoBin;
}

void enter(uint place, uint t, inout TreeNode node) {
    uvec4 corners = fetch(triangles, t);
    vec3 a = fetch(positions, corners.x).xyz;
    vec3 b = fetch(positions, corners.y).xyz;
    vec3 c = fetch(positions, corners.z).xyz;
    vec3 low = min(a, min(b, c));
    vec3 high = max(a, max(b, c));
    uint piece = corners.w >> 8;
    uint bin = binOfTriangle(a, b, c, piece);
    if (!within(a, kNothing) || !within(b, kNothing) || !within(c, kNothing)) return;
    boxes[2u * place] = uvec4(floatBitsToUint(low), bin);
    boxes[2u * place + 1u] = uvec4(floatBitsToUint(high), t);
    vec3 u = fetch(velocities, corners.x).xyz;
    vec3 v = fetch(velocities, corners.y).xyz;
    vec3 w = fetch(velocities, corners.z).xyz;
    bool sane = within(u, kAnySpeed) && within(v, kAnySpeed) && within(w, kAnySpeed);
    node.low = min(node.low, low);
    node.high = max(node.high, high);
    node.slowest = min(node.slowest, sane ? min(u, min(v, w)) : vec3(-kAnySpeed));
    node.fastest = max(node.fastest, sane ? max(u, max(v, w)) : vec3(kAnySpeed));
    node.directions |= 1u << bin;
    node.firstPiece = min(node.firstPiece, piece);
    node.lastPiece = max(node.lastPiece, piece);
}

void fitLeaf(uint i) {
    TreeNode node = emptyNode();
    node.firstChild = kTreeFan * i;
    for (uint place = kTreeFan * i; place < kTreeFan * (i + 1u); ++place) {
        boxes[2u * place] = uvec4(floatBitsToUint(vec3(kNothing)), kNoBin);
        boxes[2u * place + 1u] = uvec4(floatBitsToUint(vec3(-kNothing)), kNoVertex);
        uint t = fetch(order, place).x;
        if (t < uniforms.triangle_count) {
            enter(place, t, node);
        }
    }
    writeNode(i, node);
}

// Node i of the level that begins at `first`, from the one that lies between `below` and it.
void fitNode(uint i, uint below, uint first) {
    TreeNode node = emptyNode();
    node.firstChild = below + kTreeFan * i;
    uint end = min(node.firstChild + kTreeFan, first);
    for (uint child = node.firstChild; child < end; ++child) {
        uvec4 low = nodes[4u * child];
        uvec4 high = nodes[4u * child + 1u];
        uvec4 slowest = nodes[4u * child + 2u];
        uvec4 fastest = nodes[4u * child + 3u];
        node.low = min(node.low, uintBitsToFloat(low.xyz));
        node.high = max(node.high, uintBitsToFloat(high.xyz));
        node.slowest = min(node.slowest, uintBitsToFloat(slowest.xyz));
        node.fastest = max(node.fastest, uintBitsToFloat(fastest.xyz));
        node.directions |= low.w;
        node.firstPiece = min(node.firstPiece, slowest.w);
        node.lastPiece = max(node.lastPiece, fastest.w);
    }
    writeNode(first + i, node);
}

void endLevel() {
    memoryBarrierBuffer();
    barrier();
}

// The levels above the second.
void fitTop(uint below, uint count) {
    uint first = below + count;
    while (count > kTreeFan) {
        count = nodesAbove(count);
        for (uint i = gl_LocalInvocationID.x; i < count; i += kGroupSize) {
            fitNode(i, below, first);
        }
        endLevel();
        below = first;
        first += count;
    }
}

shared bool isLast;

// The group that finds all others done.
void findLast(uint groups) {
    if (gl_LocalInvocationID.x == 0u) {
        isLast = atomicAdd(state.fitted_groups, 1u) == groups - 1u;
        if (isLast) state.fitted_groups = 0u;
    }
    endLevel();
}

void fitTree() {
    uint i = gl_GlobalInvocationID.x;
    uint above = nodesAbove(leaves);
    if (i < leaves) fitLeaf(i);
    endLevel();
    uint own = gl_WorkGroupID.x * (kGroupSize / kTreeFan) + gl_LocalInvocationID.x;
    if (gl_LocalInvocationID.x < kGroupSize / kTreeFan && own < above) fitNode(own, 0u, leaves);
    endLevel();
    findLast((leaves + kGroupSize - 1u) / kGroupSize);
    if (isLast) fitTop(leaves, above);
}

// How thick the material behind a vertex is at rest: the shortest of its ISPCs, of those that end
// beside it where none begin [m].
float wallBehind(uint v) {
    float own = kNoWall;
    float others = kNoWall;
    uvec2 range = fetch(columnRanges, v).xy;
    for (uint k = range.x; k < range.y; ++k) {
        uvec2 share = fetch(columnShares, k).xy;
        float size = uintBitsToFloat(fetch(columns, 2u * share.x + 1u).z);
        if (uintBitsToFloat(share.y) > 0.5) {  // of a weight of 1
            own = min(own, size);
        } else {
            others = min(others, size);
        }
    }
    return own < kNoWall ? own : others;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v == 0u) startAnew();
    if (v < vertices) {
        VertexNormals own = normalsOf(v, positions);
        normals[2u * v] = vec4(own.skin, float(own.kinds));
        normals[2u * v + 1u] = vec4(own.wall, 0.0);
    }
    if (v < restVertices) {
        VertexNormals own = normalsOf(v, restPositions);
        restNormals[2u * v] = vec4(own.skin, wallBehind(v));
        restNormals[2u * v + 1u] = vec4(own.wall, 0.0);
    }
    if (gl_WorkGroupID.x * kGroupSize < leaves) fitTree();
}
