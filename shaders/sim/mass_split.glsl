// Mass splitting: each of the n constraints of a type at a vertex has a share of its mass, hence
// the inverse mass n w. While a type is solved, w of the displacement holds n times the inverse
// unit mass, so that a constraint need not look n up. The includer declares `uniforms`.

// For the next type that is on, from `first` on. counts: VertexLinks.
float splitFrom(uint first, float inverseUnitMass, uvec4 counts) {
#define COUNT_IF_NEXT(number, Name, list, Constraint, Gather)                      \
    first <= number && (uniforms.active_parts & k##Name##Part) != 0u               \
        ? counts[number - 1u] :
    return inverseUnitMass * float(KERF_PULLING(COUNT_IF_NEXT) 0u);
#undef COUNT_IF_NEXT
}
