// The skin, in rest space: it stays attached whatever the body does. SKIN: 0 mottled, 1 spotted,
// 2 peel, 3 meat, 4 sponge, 5 wood, 6 stone.
#include "rest_space.glsl"
#include "solid.glsl"

uniform vec3 skinColor;
uniform vec3 rindColor;
uniform float mottle;  // strength of the broad variation
uniform float spots;   // strength of the spots

#if SKIN == 1
// Round spots of different sizes: balls around jittered points, one in each unit cell.
float spotCover(vec3 p) {
    ivec3 base = ivec3(floor(p - 0.5));
    float cover = 0.0;
    for (int i = 0; i < 8; ++i) {
        ivec3 cell = base + ivec3(i & 1, (i >> 1) & 1, i >> 2);
        float pick = hash(cell);
        vec3 jitter = vec3(fract(pick * 61.0), fract(pick * 467.0), fract(pick * 3571.0)) - 0.5;
        float radius = 0.04 + 0.26 * pick * pick;
        float away = distance(p, vec3(cell) + 0.5 + 0.5 * jitter);
        cover = max(cover, 1.0 - smoothstep(radius - 0.05, radius + 0.02, away));
    }
    return cover;
}
#endif

vec3 skinAlbedo(vec3 rest) {
    vec3 u = inUnits(rest);
#if SKIN == 3
    return meatColor(u, skinColor, rindColor, 0.14);
#elif SKIN == 4
    return spongeColor(u, skinColor, rindColor);
#elif SKIN == 5
    return woodColor(u, skinColor, rindColor);
#elif SKIN == 6
    return stoneColor(u, skinColor, rindColor);
#else
    vec3 c = skinColor * (1.0 + mottle * (valueNoise(u * 3.5) - 0.5));
#if SKIN == 1
    c = mix(c, c * vec3(0.42, 0.34, 0.34), spots * spotCover(u * 9.0));
#elif SKIN == 2
    c *= 1.0 - 0.14 * smoothstep(0.1, 0.6, holes(u * 24.0, 0.15, 0.45));
#endif
    return c;
#endif
}

#if SKIN == 2 || SKIN == 4
#define BUMPS
// [m]
float heightOf(vec3 rest) {
    vec3 u = inUnits(rest);
    float size = max(restExtent.x, max(restExtent.y, restExtent.z));
#if SKIN == 2
    return -0.004 * size * smoothstep(0.0, 0.6, holes(u * 24.0, 0.15, 0.45));
#else
    return -0.03 * size * spongeHoles(u);
#endif
}
#endif
