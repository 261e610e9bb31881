// The rows of contact of a step: ContactRow, RowState.
STATE_TEXELS(kContactRowsUnit) rows;

ContactRow rowAt(uint row) {
    return ContactRow(fetch(rows, 3u * row), fetch(rows, 3u * row + 1u),
                      fetch(rows, 3u * row + 2u));
}

float pushOf(float stiffness, float gap) {
    return stiffness * max(-gap, 0.0);
}

// What holds back at a slip [N/m]: less where friction does not hold it.
float gripOf(float stiffness, vec3 slip, float most) {
    float size = length(slip);
    return stiffness * size > most ? most / size : stiffness;
}
