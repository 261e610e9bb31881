// Up to where the vertices of each piece look for triangles until the next search: of their own
// piece as far as its parts can approach one another, of others as far as those can come that can
// come near. So what moves fast elsewhere costs nothing here. Cells are as wide as a piece needs
// for itself.
// Reads motions, pieces. Writes reaches, the size of cells. One group. A storage barrier follows.
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kContactUniformsBinding) buffer Uniforms { ContactUniforms uniforms; };
layout(std430, binding = kContactPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kContactMotionBinding) readonly buffer Motions { PieceMotion motions[]; };
layout(std430, binding = kContactReachBinding) writeonly buffer Reaches { PieceReach reaches[]; };

#include "sim/numbers.glsl"

#include "sim/ordered_floats.glsl"

struct Box {
    vec3 low;
    vec3 high;
};

Box boxOf(PieceBounds b) {
    return Box(vec3(orderedFloat(~b.low_x), orderedFloat(~b.low_y), orderedFloat(~b.low_z)),
               vec3(orderedFloat(b.high_x), orderedFloat(b.high_y), orderedFloat(b.high_z)));
}

// What rounding may add to a way.
const float kSlack = 1.001;

// Of pairs that differ by `velocity` at most.
float reachAt(vec3 velocity) {
    float reach = kSlack * (uniforms.reach + uniforms.interval * length(velocity));
    return reach <= uniforms.margin ? reach : uniforms.margin;  // what is not finite, too
}

float apart(Box a, Box b) {
    return length(max(max(a.low - b.high, b.low - a.high), vec3(0.0)));
}

float reachToOthers(uint p, Box place, Box velocity) {
    float reach = 0.0;
    for (uint q = 0u; q < numbers.x; ++q) {
        if (q == p || pieces[q].constrained == 0u) continue;
        Box other = boxOf(motions[q].velocity);
        float both = reachAt(max(velocity.high - other.low, other.high - velocity.low));
        if (both > reach && !(apart(place, boxOf(motions[q].place)) > both)) reach = both;
    }
    return reach;
}

shared float widest[kGroupSize];

void main() {
    uint self = gl_LocalInvocationID.x;
    widest[self] = uniforms.reach;
    for (uint p = self; p < numbers.x; p += kGroupSize) {
        PieceReach reach = PieceReach(-1.0, -1.0);
        if (pieces[p].constrained != 0u) {
            Box velocity = boxOf(motions[p].velocity);
            reach.own = reachAt(velocity.high - velocity.low);
            reach.others = reachToOthers(p, boxOf(motions[p].place), velocity);
        }
        reaches[p] = reach;
        widest[self] = max(widest[self], reach.own);
    }
    for (uint count = kGroupSize / 2u; count > 0u; count /= 2u) {
        barrier();
        if (self < count) widest[self] = max(widest[self], widest[self + count]);
    }
    if (self == 0u) uniforms.cell = 2.0 * widest[0];
}
