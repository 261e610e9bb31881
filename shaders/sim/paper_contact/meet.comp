// The pairs of triangles of two pieces that meet, and what each of a pair asks of the other, as the
// paper has it. A pair is found by the triangle of the lower number.
// Reads X, velocities, triangles, boxes of pieces, the tree. Adds to the requests of both, as
// integers, which do not mind the order in which threads come, and to the number of contacts. One
// thread per triangle. A storage barrier follows.
#include "box_records.h"
#include "sim/contact/uniforms.glsl"
#include "sim/base/fetch.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactVelocitiesBinding) readonly buffer Velocities {
    vec4 velocities[];
};
layout(std430, binding = kPaperRequestsBinding) buffer Requests { PaperRequest requests[]; };
layout(std430, binding = kPaperPiecesBinding) readonly buffer Bounds { PieceBounds bounds[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(binding = kContactBoxesBinding) uniform usamplerBuffer boxes;
layout(binding = kContactNodesBinding) uniform usamplerBuffer nodes;
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "sim/base/numbers.glsl"

#include "response.glsl"
#include "sim/base/ordered_floats.glsl"

// As many levels as there will ever be.
const uint kMostNodes = 16u * kTreeFan;

vec3 lowOf(PieceBounds b) {
    return vec3(orderedFloat(b.low_x), orderedFloat(b.low_y), orderedFloat(b.low_z));
}

vec3 highOf(PieceBounds b) {
    return vec3(orderedFloat(b.high_x), orderedFloat(b.high_y), orderedFloat(b.high_z));
}

vec3 middleOfPiece(uint piece) {
    return 0.5 * (lowOf(bounds[piece]) + highOf(bounds[piece]));
}

bool overlap(vec3 lowA, vec3 highA, vec3 lowB, vec3 highB) {
    return all(lessThanEqual(lowA, highB)) && all(lessThanEqual(lowB, highA));
}

bool meetsOtherPiece(uint piece, vec3 low, vec3 high) {
    bool meets = false;
    for (uint p = 0u; p < numbers.x; ++p) {
        meets = meets || (p != piece && overlap(low, high, lowOf(bounds[p]), highOf(bounds[p])));
    }
    return meets;
}

MovingTriangle triangleAt(uint t) {
    uvec4 corners = triangles[t];
    vec3 velocity = (velocities[corners.x].xyz + velocities[corners.y].xyz +
                     velocities[corners.z].xyz) / 3.0;
    return MovingTriangle(positions[corners.x].xyz, positions[corners.y].xyz,
                          positions[corners.z].xyz, velocity, middleOfPiece(corners.w >> 8));
}

ivec3 inSteps(vec3 way) {
    return ivec3(round(way / uniforms.unit));
}

void ask(uint t, ivec3 loss, ivec3 push) {
    atomicAdd(requests[t].loss_x, loss.x);
    atomicAdd(requests[t].loss_y, loss.y);
    atomicAdd(requests[t].loss_z, loss.z);
    atomicAdd(requests[t].push_x, push.x);
    atomicAdd(requests[t].push_y, push.y);
    atomicAdd(requests[t].push_z, push.z);
    atomicAdd(requests[t].count, 1u);
}

void answer(uint t, uint other) {
    MovingTriangle a = triangleAt(t);
    MovingTriangle b = triangleAt(other);
    if (!intersect(a, b)) return;
    PaperResponse response = responseOf(a, b);
    ivec3 loss = inSteps(response.loss);
    ivec3 push = inSteps(response.push);
    ask(t, loss, push);
    ask(other, -loss, -push);
    atomicAdd(state.contacts, 1u);
}

struct Searcher {
    uint triangle;
    uint piece;
    vec3 low;
    vec3 high;
};

bool meetsNode(Searcher self, uint node) {
    vec3 low = uintBitsToFloat(fetch(nodes, 4u * node).xyz);
    vec3 high = uintBitsToFloat(fetch(nodes, 4u * node + 1u).xyz);
    uint first = fetch(nodes, 4u * node + 2u).w;
    uint last = fetch(nodes, 4u * node + 3u).w;
    return overlap(self.low, self.high, low, high) && (first != self.piece || last != self.piece);
}

void lookAt(Searcher self, uint place) {
    uvec4 low = fetch(boxes, 2u * place);
    uvec4 high = fetch(boxes, 2u * place + 1u);
    if (overlap(self.low, self.high, uintBitsToFloat(low.xyz), uintBitsToFloat(high.xyz)) &&
        high.w > self.triangle && triangles[high.w].w >> 8 != self.piece) {
        answer(self.triangle, high.w);
    }
}

uint stack[kMostNodes];

void search(Searcher self) {
    uint size = 0u;
    for (uint i = 0u; i < kTreeFan; ++i) {
        stack[size++] = numbers.y + i;
    }
    while (size > 0u) {
        uint node = stack[--size];
        if (!meetsNode(self, node)) continue;
        uint first = fetch(nodes, 4u * node + 1u).w;
        for (uint i = first; i < first + kTreeFan; ++i) {
            if (node < numbers.z) {
                lookAt(self, i);
            } else {
                stack[size++] = i;
            }
        }
    }
}

void main() {
    uint t = gl_GlobalInvocationID.x;
    if (t >= uniforms.triangle_count) return;
    vec3 a = positions[triangles[t].x].xyz;
    vec3 b = positions[triangles[t].y].xyz;
    vec3 c = positions[triangles[t].z].xyz;
    Searcher self = Searcher(t, triangles[t].w >> 8, min(a, min(b, c)), max(a, max(b, c)));
    if (meetsOtherPiece(self.piece, self.low, self.high)) search(self);
}
