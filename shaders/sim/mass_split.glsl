// Mass splitting: each of the n constraints of a kind at a vertex has a share of its mass, hence
// the inverse mass n w. While a kind is solved, w of the displacement holds n times the inverse
// unit mass, so that a constraint need not look n up. The includer declares `uniforms`.

// For the bends, which follow the edges, or for the ISPCs where there are none. counts:
// VertexLinks.
float firstSplit(float inverseUnitMass, uvec4 counts) {
    bool bends = (uniforms.active_parts & kBendPart) != 0u;
    return inverseUnitMass * float(bends ? counts.y : counts.z);
}

// For the ISPCs.
float secondSplit(float inverseUnitMass, uvec4 counts) {
    return inverseUnitMass * float(counts.z);
}
