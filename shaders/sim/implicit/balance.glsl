// By which pieces that nothing holds are moved as a whole, so that their momentum is what the
// forces on them say, however few the iterations.
vec3 balancingShift(uint index, uint slot) {
    vec4 left = vec4(0.0);
    bool held = false;
    for (uint p = pieceAt(index).root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        left += sumOfAnswers(piece, slot).second;
        held = held || piece.held != 0u;
        p = piece.next;
    }
    return !held && left.w < kHeldMass ? left.xyz / (implicit.inertia * left.w) : vec3(0.0);
}
