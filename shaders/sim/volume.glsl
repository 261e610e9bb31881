// What the volume constraint sums up: see volume_gradient.comp. The includer declares `uniforms`,
// positionOf(v), displacementOf(v), neighbourAt(place) and rangeAt(v) of the neighbours, placeAt(place),
// pageAt(index), setGradient(v, dV/dp) and sumOfBlock(block).

// The sums of kGroupSize places are added up in so many rows first.
const uint kSumRows = 16u;

// Sixfold gradients, see volume_gradient.glsl.
struct GradientPair {
    vec3 before;  // at X
    vec3 now;     // at X + d
};

GradientPair sixfoldGradients(vec3 x, vec3 d, uvec2 range) {
    GradientPair sum = GradientPair(vec3(0.0), vec3(0.0));
    uint corner = neighbourAt(range.x);
    vec3 firstBefore = positionOf(corner).xyz - x;
    vec3 first = firstBefore + (displacementOf(corner).xyz - d);
    vec3 lastBefore = firstBefore;
    vec3 last = first;
    for (uint k = range.x + 1u; k < range.y; ++k) {
        corner = neighbourAt(k);
        vec3 nextBefore = positionOf(corner).xyz - x;
        vec3 next = nextBefore + (displacementOf(corner).xyz - d);
        sum.before += cross(lastBefore, nextBefore);
        sum.now += cross(last, next);
        lastBefore = nextBefore;
        last = next;
    }
    sum.before += cross(lastBefore, firstBefore);
    sum.now += cross(last, first);
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

// Of a place of all pages of a block; the origin of its piece at X, and its d.
vec2 sumOverPages(BlockRecord block, vec3 originX, vec3 originD, uint place) {
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < block.page_count; ++i) {
        uint v = placeAt(kPageSize * pageAt(block.first_page + i) + place);
        if (v != kNoVertex) {
            VolumeShare share = volumeShare(v, originX, originD);
            setGradient(v, share.gradient);
            sum += share.sum;
        }
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
