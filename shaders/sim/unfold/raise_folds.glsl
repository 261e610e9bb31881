// Raises the fold of each vertex of a bend to that of the bend at X. The includer declares
// positionOf(v), raiseFold(v, fold).
void raiseFolds(BendRecord bend) {
    vec4 x0 = positionOf(bend.v0);
    vec4 x1 = positionOf(bend.v1);
    vec4 x2 = positionOf(bend.v2);
    vec4 x3 = positionOf(bend.v3);
    bool free = min(min(x0.w, x1.w), min(x2.w, x3.w)) > 0.0;
    Wings wings = wingsOf(x1.xyz - x0.xyz, x2.xyz - x0.xyz, x3.xyz - x0.xyz);
    float fold = free ? foldOf(wings, bend) : 0.0;
    for (uint once = fold > 0.0 ? 1u : 0u; once > 0u; --once) {
        raiseFold(bend.v0, fold);
        raiseFold(bend.v1, fold);
        raiseFold(bend.v2, fold);
        raiseFold(bend.v3, fold);
    }
}
