// The answer of groups to the residual by their modes: rows of the inverse at rest, which are added
// up in parts. The includer calls findModes() with all threads of a group of GROUP.
STATE_TEXELS(kCoarseUnit) coarse;
STATE_TEXELS(kModesBinding) modes;

const uint kParts = 4u;  // of a row, each every fourth group
shared float parts[kAggregateModes * kParts];
shared float ownModes[kAggregateModes];

// `all`: the first of the groups, and how many.
float partOf(uint row, uint part, uvec2 all, uint firstTexel) {
    float sum = 0.0;
    for (uint k = part; k < all.y; k += kParts) {
        uint at = firstTexel + 3u * (row * all.y + k);
        uint from = 3u * (all.x + k);
        sum += dot(fetch(coarse, at), fetch(modes, from));
        sum += dot(fetch(coarse, at + 1u), fetch(modes, from + 1u));
        sum += dot(fetch(coarse, at + 2u), fetch(modes, from + 2u));
    }
    return sum;
}

float modeOf(uint row) {
    uint at = kParts * row;
    return (parts[at] + parts[at + 1u]) + (parts[at + 2u] + parts[at + 3u]);
}

// Leaves ownModes.
void findModes(uvec2 all, uint firstTexel) {
    for (uint task = gl_LocalInvocationID.x; task < kAggregateModes * kParts; task += GROUP) {
        parts[task] = partOf(task / kParts, task % kParts, all, firstTexel);
    }
    barrier();
    for (uint row = gl_LocalInvocationID.x; row < kAggregateModes; row += GROUP) {
        ownModes[row] = modeOf(row);
    }
    barrier();
}

// Along an axis.
vec4 modesOf(uint axis) {
    uint row = 4u * axis;
    return vec4(ownModes[row], ownModes[row + 1u], ownModes[row + 2u], ownModes[row + 3u]);
}
