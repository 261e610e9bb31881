// The boxes of triangles and of the lowest nodes of the tree. Reads X, velocities, triangles,
// pieces, the order of triangles. Writes boxes and nodes. One thread per node. A storage barrier
// follows, then tree_nodes.
#include "sim/contact/uniforms.glsl"
#include "sim/fetch.glsl"
layout(local_size_x = kGroupSize) in;
layout(binding = kContactPositionsBinding) uniform samplerBuffer positions;
layout(binding = kContactVelocitiesBinding) uniform samplerBuffer velocities;
layout(binding = kContactTrianglesBinding) uniform usamplerBuffer triangles;
layout(binding = kContactOrderBinding) uniform usamplerBuffer order;
layout(std430, binding = kContactPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kContactBoxesBinding) writeonly buffer Boxes { uvec4 boxes[]; };
layout(std430, binding = kContactNodesBinding) writeonly buffer Nodes { uvec4 nodes[]; };

#include "directions.glsl"
#include "sim/numbers.glsl"
#include "tree.glsl"
#include "write_node.glsl"

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

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= numbers.x) return;
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
