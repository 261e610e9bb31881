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

// The second stage goes on by 2.4 times what the first one pushed, so that a vertex alone would leave
// faster than it came. There a contact resists its opening from where the first stage leads to
// (RowState), and may pull, by less than it has pushed.
// What a contact pushes, and how much less it does by metre of its opening.
struct Push {
    float force;
    float firmness;
};

// `pushes`: see RowState; `lead`: see ContactRow.
Push pushOf(float stiffness, float gap, vec4 pushes, float lead) {
    Push push = Push(stiffness * max(-gap, 0.0), gap < 0.0 ? stiffness : 0.0);
    if (pushes.w < kUndamped) {
        push.force += kDampedContact * stiffness * (pushes.w - gap);
        push.firmness += kDampedContact * stiffness;
        float least = -kMostPull * pushes.z;
        if (push.force < least) push = Push(least, 0.0);
    }
    if (lead < 0.0 && push.force > -lead) push = Push(-lead, 0.0);
    return push;
}

// What holds back at a slip [N/m]: less where friction does not hold it.
float gripOf(float stiffness, vec3 slip, float most) {
    float size = length(slip);
    return stiffness * size > most ? most / size : stiffness;
}
