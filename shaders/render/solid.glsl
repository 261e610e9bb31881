// Materials that go all through a body, so that skin and cut faces have one pattern. Coordinates as
// of inUnits(); `second`: the colour of rings, veins and holes.

// Rings about an upright stem beside the middle, with fibres along it.
vec3 woodColor(vec3 u, vec3 base, vec3 second) {
    vec3 q = u - vec3(0.22, 0.0, -0.16);
    float bend = 0.10 * (valueNoise(vec3(1.7, 0.6, 1.7) * u) - 0.5);
    float wobble = 0.05 * (valueNoise(vec3(5.0, 1.2, 5.0) * u) - 0.5);
    float radius = length(q.xz + bend * q.y) + wobble;
    float ring = radius * 11.0 + 0.6 * valueNoise(vec3(0.5 * radius, 0, 0) + 9.0);
    float within = fract(ring);
    float soft = clamp(2.0 * fwidth(ring), 0.02, 0.5);
    float late = smoothstep(0.35, 0.92, within) * (1.0 - smoothstep(1.0 - soft, 1.0, within));
    float fibre = valueNoise(u * vec3(60.0, 4.0, 60.0)) - 0.5;
    float year = hash(ivec3(int(floor(ring)), 3, 7)) - 0.5;
    vec3 c = base * (1.0 + 0.16 * fibre + 0.22 * year);
    return mix(c, second, 0.62 * late);
}

// Clouds, and veins where warped noise crosses its middle.
vec3 stoneColor(vec3 u, vec3 base, vec3 second) {
    vec3 warp = vec3(valueNoise(u * 2.1), valueNoise(u * 2.1 + 17.0), valueNoise(u * 2.1 + 41.0));
    vec3 q = u + 0.75 * (warp - 0.5);
    float broad = abs(2.0 * valueNoise(q * 2.4 + 3.0) - 1.0);
    float fine = abs(2.0 * valueNoise(q * 6.3 + 1.3 * warp) - 1.0);
    float veins = 0.9 * exp(-9.0 * broad) * warp.y + 0.5 * exp(-14.0 * fine) * warp.x;
    float clouds = valueNoise(q * 3.1 + 5.0);
    return mix(base * (0.80 + 0.26 * clouds), second, clamp(veins, 0.0, 0.9));
}

// Round holes of three sizes: 1 in the middle of one.
float holes(vec3 p, float least, float most) {
    ivec3 cell = ivec3(floor(p));
    vec3 at = fract(p);
    ivec3 to = ivec3(at.x < 0.5 ? -1 : 1, at.y < 0.5 ? -1 : 1, at.z < 0.5 ? -1 : 1);
    float deepest = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 offset = ivec3(i & 1, (i >> 1) & 1, i >> 2) * to;
        float pick = hash(cell + offset);
        vec3 middle = 0.5 + 0.5 * (vec3(pick, fract(pick * 57.0), fract(pick * 719.0)) - 0.5);
        float radius = mix(least, most, fract(pick * 3571.0));
        deepest = max(deepest, 1.0 - distance(at, vec3(offset) + middle) / radius);
    }
    return clamp(deepest, 0.0, 1.0);
}

float spongeHoles(vec3 u) {
    float large = smoothstep(0.0, 0.55, holes(u * 5.5, 0.12, 0.58));
    return max(large, 0.8 * smoothstep(0.0, 0.6, holes(u * 13.0 + 5.0, 0.15, 0.55)));
}

vec3 spongeColor(vec3 u, vec3 base, vec3 second) {
    float grain = valueNoise(u * 45.0) - 0.5;
    return mix(base * (1.0 + 0.22 * grain), second, 0.92 * spongeHoles(u));
}

// Bundles of fibres along x, with threads and flecks of fat between them.
vec3 meatColor(vec3 u, vec3 base, vec3 fat, float share) {
    vec3 q = u * vec3(1.0, 2.2, 2.2);
    vec3 warp = vec3(valueNoise(q * 1.8), valueNoise(q * 1.8 + 19.0), valueNoise(q * 1.8 + 43.0));
    vec3 w = q + 0.9 * (warp - 0.5);
    float strands = valueNoise(w * vec3(3.0, 24.0, 24.0)) - 0.5;
    float muscle = valueNoise(w * vec3(1.5, 4.0, 4.0)) - 0.5;
    vec3 c = base * (1.0 + 0.42 * strands + 0.5 * muscle);
    float seam = abs(2.0 * valueNoise(w * 2.6 + 7.0) - 1.0);
    float threads = (1.0 - smoothstep(0.02, 0.11, seam)) * smoothstep(0.3, 0.6, warp.y);
    float flecks = smoothstep(0.66, 0.80, valueNoise(w * vec3(4.0, 11.0, 11.0) + 3.0));
    return mix(c, fat, share * max(threads, 0.75 * flecks));
}
