// The pieces of the body, and which of them touch.
#pragma once
#include "sim/implicit/uniforms.glsl"
RECORD_QUADS(kPiecesUnit) pieces;  // two texels each: ImplicitPiece

// See ImplicitPiece.
float forceUnitOf(uint index) {
    return abs(uintBitsToFloat(fetch(pieces, 2u * index + 1u).w));
}

ImplicitPiece pieceAt(uint index) {
    uvec4 lists = fetch(pieces, 2u * index);
    uvec4 touching = fetch(pieces, 2u * index + 1u);
    return ImplicitPiece(lists.x, lists.y, lists.z, lists.w, touching.x, touching.y, touching.z,
                         uintBitsToFloat(touching.w));
}
