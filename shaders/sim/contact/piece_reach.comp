// Up to where the vertices of each piece look for triangles until the next search: of their own
// piece as far as its parts can approach one another, of others as far as those can come that can
// come near. So what moves fast elsewhere costs nothing here. Cells are as wide as a piece needs
// for itself.
//
// And whether they look at all. What a piece found before holds while its parts have hardly moved
// against one another, nor against those of each piece that can come near. Both must have looked in
// the same search, which their ways are measured from.
//
// Reads motions, pieces. Writes reaches, the size of cells, the number of the search. One group. A
// storage barrier follows.
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kContactUniformsBinding) buffer Uniforms { ContactUniforms uniforms; };
layout(std430, binding = kContactPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kContactMotionBinding) readonly buffer Motions { PieceMotion motions[]; };
layout(std430, binding = kContactReachBinding) buffer Reaches { PieceReach reaches[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

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

float diagonalOfBoth(Box a, Box b) {
    return length(max(a.high, b.high) - min(a.low, b.low));
}

// Whether what two pieces, or one with itself, found before holds until the next search.
bool holds(uint p, uint q) {
    float way = diagonalOfBoth(boxOf(motions[p].way), boxOf(motions[q].way));
    float speed = diagonalOfBoth(boxOf(motions[p].velocity), boxOf(motions[q].velocity));
    return way + uniforms.interval * speed <= uniforms.kept;
}

// How far a piece looks for others; `kept`: whether what it found of those before holds.
float reachToOthers(uint p, inout bool kept) {
    Box place = boxOf(motions[p].place);
    Box velocity = boxOf(motions[p].velocity);
    uint looked = reaches[p].looked;
    float reach = 0.0;
    for (uint q = 0u; q < numbers.x; ++q) {
        if (q == p || pieces[q].constrained == 0u) continue;
        Box other = boxOf(motions[q].velocity);
        float both = reachAt(max(velocity.high - other.low, other.high - velocity.low));
        if (apart(place, boxOf(motions[q].place)) > both) continue;
        reach = max(reach, both);
        kept = kept && reaches[q].looked == looked && holds(p, q);
    }
    return reach;
}

PieceReach reachOf(uint p) {
    uint looked = reaches[p].looked;
    if (pieces[p].constrained == 0u) return PieceReach(-1.0, -1.0, 1u, looked);
    Box velocity = boxOf(motions[p].velocity);
    bool kept = state.searches > 0u && holds(p, p);
    float others = reachToOthers(p, kept);
    return PieceReach(reachAt(velocity.high - velocity.low), others, kept ? 0u : 1u, looked);
}

shared float widest[kGroupSize];

void main() {
    uint self = gl_LocalInvocationID.x;
    widest[self] = uniforms.reach;
    for (uint p = self; p < numbers.x; p += kGroupSize) {
        PieceReach reach = reachOf(p);
        reaches[p] = reach;
        if (reach.looks != 0u) widest[self] = max(widest[self], reach.own);
    }
    for (uint count = kGroupSize / 2u; count > 0u; count /= 2u) {
        barrier();
        if (self < count) widest[self] = max(widest[self], widest[self + count]);
    }
    // By now all have read when others looked.
    for (uint p = self; p < numbers.x; p += kGroupSize) {
        if (reaches[p].looks != 0u) reaches[p].looked = state.searches + 1u;
    }
    barrier();
    if (self == 0u) {
        uniforms.cell = 2.0 * widest[0];
        ++state.searches;
    }
}
