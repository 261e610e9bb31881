// Between the modes of aggregates and those of their regions, of which each affine motion of a
// region is one of its aggregates. The includer has `modes` and `turns`.
STATE_TEXELS(kLevelsUnit) levels;

// What share m of an aggregate is in its region: x of a translation, y of its own.
vec2 levelOf(uint aggregate, uint m) {
    if (m == 0u) return vec2(0.0, 1.0);
    return vec2(fetch(levels, 2u * aggregate)[m - 1u], fetch(levels, 2u * aggregate + 1u)[m - 1u]);
}

uint regionOf(uint aggregate) { return uint(fetch(levels, 2u * aggregate).w); }

vec4 turnOfAggregate(uint aggregate) { return fetch(turns, implicit.patch_count + aggregate); }
vec4 turnOfRegion(uint region) {
    return fetch(turns, implicit.patch_count + implicit.aggregate_count + region);
}

vec3 turnedBack(vec4 turn, vec3 v) { return rotated(vec4(-turn.xyz, turn.w), v); }

// Of the mode m in three texels, along all axes.
vec3 modeAt(uint first, uint m) {
    return vec3(fetch(modes, first)[m], fetch(modes, first + 1u)[m], fetch(modes, first + 2u)[m]);
}

// Where the residual by modes of a region lies, and its motion.
uint residualOfRegion(uint region) { return 3u * (implicit.aggregate_count + region); }
uint motionOfRegion(uint region) { return residualOfRegion(implicit.region_count + region); }
