// What happens to each vertex by itself at the end of a substep. The includer declares `uniforms`,
// gradientOf(v), impulseFor(piece) and pieceOf(v).
#include "sim/finish.glsl"
#include "sim/floor.glsl"
#include "sim/volume_correct.glsl"

// d once the piece of the vertex has its volume.
vec3 heldByVolume(uint v, vec3 d, float inverseUnitMass) {
    uint piece = pieceOf(v);
    float impulse = impulseFor(piece == kNoPiece ? 0u : piece);
    vec3 held = withVolume(d, inverseUnitMass, impulse, gradientOf(v));
    return piece == kNoPiece ? d : held;
}
