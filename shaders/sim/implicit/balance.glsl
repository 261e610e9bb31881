// By which pieces are moved as a whole, so that their momentum is what the forces on them say,
// however few the iterations. Not where a vertex is held.
vec3 balancingShift(uint index, uint slot) {
    vec4 left = vec4(0.0);
    for (uint p = pieceAt(index).root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        left += sumOfAnswers(piece, slot).second;
        p = piece.next;
    }
    return left.w < kHeldMass ? left.xyz / (implicit.inertia * left.w) : vec3(0.0);
}
