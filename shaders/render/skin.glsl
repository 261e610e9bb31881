// The skin, in rest space: it stays attached whatever the body does. SPOTS adds spots.
#include "rest_space.glsl"

uniform vec3 skinColor;
uniform float mottle;  // strength of the broad variation
uniform float spots;   // strength of the spots

#ifdef SPOTS
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
    vec3 c = skinColor * (1.0 + mottle * (valueNoise(u * 3.5) - 0.5));
#ifdef SPOTS
    c = mix(c, c * vec3(0.42, 0.34, 0.34), spots * spotCover(u * 9.0));
#endif
    return c;
}
