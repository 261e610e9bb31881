// By which a piece that nothing holds is moved as a whole, so that its momentum is what the forces
// on it say, however few the iterations.
vec3 balancingShift(uint piece, uint slot) {
    vec4 left = sumOfAnswers(pieceAt(piece), slot).second;
    return left.w < kHeldMass ? left.xyz / (implicit.inertia * left.w) : vec3(0.0);
}
