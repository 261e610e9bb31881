// What the volume constraint sums up: see volume_gradient.comp. The includer declares `uniforms`,
// positionOf(v), displacementOf(v), neighboursAt(pair of places) and rangeAt(v) of the neighbours,
// placeAt(place), setGradient(v, dV/dp) and sumOfBlock(block).

// Sixfold gradients, see sixfold_gradient.glsl.
struct GradientPair {
    vec3 before;  // at X
    vec3 now;     // at X + d
};

struct Arm {
    vec3 before;  // at X
    vec3 now;     // at X + d
};

Arm armTo(uint v, vec3 x, vec3 d) {
    vec3 before = positionOf(v).xyz - x;
    return Arm(before, before + (displacementOf(v).xyz - d));
}

void addTriangle(inout GradientPair sum, Arm a, Arm b) {
    sum.before += cross(a.before, b.before);
    sum.now += cross(a.now, b.now);
}

// Two neighbours a turn: lists begin at even places.
GradientPair sixfoldGradients(vec3 x, vec3 d, uvec2 range) {
    GradientPair sum = GradientPair(vec3(0.0), vec3(0.0));
    uvec2 pair = neighboursAt(range.x / 2u);
    Arm first = armTo(pair.x, x, d);
    Arm last = armTo(pair.y, x, d);
    addTriangle(sum, first, last);
    for (uint k = range.x + 2u; k < range.y; k += 2u) {
        pair = neighboursAt(k / 2u);
        Arm next = armTo(pair.x, x, d);
        addTriangle(sum, last, next);
        last = armTo(k + 1u < range.y ? pair.y : pair.x, x, d);
        addTriangle(sum, next, last);
    }
    addTriangle(sum, last, first);
    return sum;
}

struct VolumeShare {
    vec3 gradient;  // dV/dp at X
    vec2 sum;       // of volume and denominator, see VolumeSum
};

// Of a vertex, about a vertex of its piece at X and X + d.
VolumeShare volumeShare(uint v, vec3 originX, vec3 originD) {
    vec4 x = positionOf(v);
    vec3 d = displacementOf(v).xyz;
    GradientPair sixfold = sixfoldGradients(x.xyz, d, rangeAt(v));
    vec3 g = sixfold.before / 6.0;
    vec3 arm = (x.xyz - originX) + (d - originD);
    return VolumeShare(g, vec2(dot(arm, sixfold.now) / 18.0,
                               uniforms.inverse_density * x.w * dot(g, g)));
}

// Of the vertex at a place, if there is one, about the origin of its piece at X, and its d.
vec2 sumAt(uint place, vec3 originX, vec3 originD) {
    uint v = placeAt(place);
    vec2 sum = vec2(0.0);
    if (v != kNoVertex) {
        VolumeShare share = volumeShare(v, originX, originD);
        setGradient(v, share.gradient);
        sum = share.sum;
    }
    return sum;
}

float impulseOver(PieceRecord piece) {
    float volume = 0.0;
    float denominator = 0.0;
    for (uint k = 0u; k < piece.block_count; ++k) {
        VolumeSum sum = sumOfBlock(piece.first_block + k);
        volume += sum.volume;
        denominator += sum.denominator;
    }
    bool holds = piece.constrained != 0u && denominator > 0.0;
    return holds ? -(volume - piece.target_volume) / denominator : 0.0;
}
