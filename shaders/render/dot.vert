// Round dots of constant size at vertices of the body. KIND: 0 a list of vertices, 1 contacts.
#include "body_records.h"
#include "contact_records.h"
#include "render_bindings.h"
layout(std430, binding = kBindPositions) readonly buffer Positions { vec4 positions[]; };
#if KIND == 0
layout(std430, binding = kBindConstraints) readonly buffer Chosen { uint chosen[]; };
#else
layout(std430, binding = kBindConstraints) readonly buffer Records { ContactRecord records[]; };
layout(std430, binding = kBindContactState) readonly buffer State { ContactState state; };
#endif

uniform mat4 viewProjection;
uniform vec2 viewport;  // [px]
uniform float radius;   // [px]
noperspective out vec2 place;  // from the middle [px]

// kNoVertex: none.
uint vertexOf(int index) {
#if KIND == 0
    return chosen[index];
#else
    bool touches = uint(index) < state.points && records[index].v1 != kNoVertex;
    return touches ? records[index].v0 : kNoVertex;
#endif
}

void main() {
    int corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
    uint vertex = vertexOf(gl_VertexID / 6);
    place = (vec2(corner & 1, corner >> 1) * 2.0 - 1.0) * (radius + 1.0);
    if (vertex == kNoVertex) {
        gl_Position = vec4(2, 2, 2, 1);
        return;
    }
    vec4 middle = viewProjection * vec4(positions[vertex].xyz, 1);
    gl_Position = middle + vec4(place * 2.0 / viewport * middle.w, -6e-4 * middle.w, 0);
}
