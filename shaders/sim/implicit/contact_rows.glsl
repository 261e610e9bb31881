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

// What a contact pushes, and how much less it does by metre of its opening.
struct Push {
    float force;
    float firmness;
};

// The second stage goes on by 2.4 times what the first one pushed, so that a vertex alone would
// leave faster than it came. What was pushed is damped there as it goes beyond where the first
// stage leads to, and pulled by less than it was pushed. `pushes`: see RowState; `lead`: see
// ContactRow.
Push pushOf(float stiffness, float gap, vec4 pushes, float lead) {
    if (gap > pushes.w) {
        float pull = kDampedContact * stiffness * (gap - pushes.w);
        float most = kMostPull * pushes.z;
        return pull < most ? Push(-pull, kDampedContact * stiffness) : Push(-most, 0.0);
    }
    float force = stiffness * max(-gap, 0.0);
    if (lead < 0.0 && force > -lead) return Push(-lead, 0.0);
    return Push(force, gap < 0.0 ? stiffness : 0.0);
}

// What holds back at a slip [N/m]: less where friction does not hold it.
float gripOf(float stiffness, vec3 slip, float most) {
    float size = length(slip);
    return stiffness * size > most ? most / size : stiffness;
}
