// With UNFOLDS folded skin does not touch what was beside it at rest nor its own piece. The
// includer declares `contact` (ContactUniforms), with UNFOLDS pieceOf(v).
#include "sim/folds.glsl"

// Whether one of the two is folded and would be caught by the other.
bool passesFold(uint v, Nearest near) {
#ifdef UNFOLDS
    bool wasBeside = near.thickness < contact.thickness;
    bool ownPiece = pieceOf(v) == near.triangle.w >> 8;
    return (wasBeside || ownPiece) && foldAt(uvec4(v, near.triangle.xyz)) > 0.0;
#else
    return false;
#endif
}
