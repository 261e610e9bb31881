// The rows of contact of a step: ContactRow, RowState.
STATE_TEXELS(kContactRowsUnit) rows;

ContactRow rowAt(uint row) {
    return ContactRow(fetch(rows, kRowTexels * row), fetch(rows, kRowTexels * row + 1u),
                      fetch(rows, kRowTexels * row + 2u), fetch(rows, kRowTexels * row + 3u));
}

float stiffnessOf(uint row) { return fetch(rows, kRowTexels * row + 1u).w; }

// Of its first vertex: what is met of the body moves with it.
float firstWeight(vec4 weights) {
    return (weights.x < 0.0 ? 1.0 : 0.0) - weights.y - weights.z - weights.w;
}

// `lead`: see ContactRow.
float pushOf(float stiffness, float gap, float lead) {
    float push = stiffness * max(-gap, 0.0);
    return lead < 0.0 ? min(push, -lead) : push;
}

// What holds back at a slip [N/m]: less where friction does not hold it.
float gripOf(float stiffness, vec3 slip, float most) {
    float size = length(slip);
    return stiffness * size > most ? most / size : stiffness;
}
