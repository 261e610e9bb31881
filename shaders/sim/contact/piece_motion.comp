// How the vertices of each piece lie and move.
// Reads X, velocities, the pieces of vertices. Writes motions, which begin with 0; a maximum does
// not mind the order in which threads come. One thread per vertex. A storage barrier follows, then
// piece_reach.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactVelocitiesBinding) readonly buffer Velocities {
    vec4 velocities[];
};
layout(std430, binding = kContactLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kContactMotionBinding) buffer Motions { PieceMotion motions[]; };

#include "sim/ordered_floats.glsl"

uvec3 wordsOf(vec3 v) {
    return uvec3(orderedWord(v.x), orderedWord(v.y), orderedWord(v.z));
}

// Most vertices lie inside of what is known already.
#define RAISE(number, word) if (word > number) atomicMax(number, word)
#define INCLUDE(bounds, words) \
    RAISE(bounds.low_x, ~words.x); \
    RAISE(bounds.low_y, ~words.y); \
    RAISE(bounds.low_z, ~words.z); \
    RAISE(bounds.high_x, words.x); \
    RAISE(bounds.high_y, words.y); \
    RAISE(bounds.high_z, words.z)

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uint p = links[v].piece;
    if (p == kNoPiece) return;
    uvec3 place = wordsOf(positions[v].xyz);
    uvec3 velocity = wordsOf(velocities[v].xyz);
    INCLUDE(motions[p].place, place);
    INCLUDE(motions[p].velocity, velocity);
}
