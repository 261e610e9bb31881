// The floor: matt, shadowed, with an anti-aliased grid that fades into the backdrop.
#include "background.glsl"
#include "light.glsl"
#include "render_bindings.h"
#include "tone.glsl"

layout(binding = kUnitGround) uniform sampler2D floorShade;

in vec3 worldPosition;
uniform vec3 eye;
uniform float cell;         // side of a small grid cell [m]
uniform vec2 floorCenter;
uniform float poolSize;     // [m]
uniform float fadeStart;    // [m] from floorCenter
uniform float fadeEnd;      // [m]
uniform mat4 shadeMatrix;   // world to the map of floorShade
uniform float hasBody;
uniform vec2 pixel;  // of the picture, 0 to 1
out vec4 color;

// Share of the pixel that lines of `width` around the integers cover (after Golus, "The best darn
// grid shader yet"): lines thinner than a pixel keep their width and lose strength instead, so that
// the grid turns grey towards the horizon without moire.
float gridCover(vec2 p, vec2 pixel, float width) {
    vec2 drawn = clamp(vec2(width), pixel, vec2(0.5));
    vec2 soft = pixel * 1.5;
    vec2 toLine = 1.0 - abs(fract(p) * 2.0 - 1.0);
    vec2 cover = smoothstep(drawn + soft, drawn - soft, toLine);
    cover *= clamp(vec2(width) / drawn, 0.0, 1.0);
    cover = mix(cover, vec2(width), clamp(pixel * 2.0 - 1.0, 0.0, 1.0));
    return mix(cover.x, 1.0, cover.y);
}

float axisCover(float p, float pixel, float width) {
    float drawn = max(width, pixel);
    return smoothstep(drawn + pixel, drawn - pixel, abs(p)) * min(1.0, 1.4 * width / drawn);
}

// x: share of the sky that the body hides, y: share of the key light that it takes.
vec2 shadeAt(vec3 point) {
    vec2 uv = (shadeMatrix * vec4(point, 1)).xy * 0.5 + 0.5;
    if (hasBody == 0.0 || any(lessThan(uv, vec2(0))) || any(greaterThan(uv, vec2(1)))) {
        return vec2(0);
    }
    return textureLod(floorShade, uv, 0).rg;
}

vec3 floorColor(vec2 p) {
    vec2 width = fwidth(p);
    vec3 albedo = mix(vec3(0.050, 0.056, 0.067), vec3(0.62, 0.63, 0.64), bright);
    float small = gridCover(p / cell, width / cell, 0.014);
    float large = gridCover(p / (5.0 * cell), width / (5.0 * cell), 0.0055);
    vec3 fine = mix(vec3(0.105, 0.115, 0.135), vec3(0.42, 0.44, 0.47), bright);
    vec3 coarse = mix(vec3(0.15, 0.165, 0.195), vec3(0.33, 0.35, 0.39), bright);
    albedo = mix(albedo, fine, 0.40 * small);
    albedo = mix(albedo, coarse, 0.62 * large);
    albedo = mix(albedo, vec3(0.42, 0.09, 0.08), 0.8 * axisCover(p.y, width.y, 0.016 * cell));
    return mix(albedo, vec3(0.08, 0.16, 0.46), 0.8 * axisCover(p.x, width.x, 0.016 * cell));
}

// The lamp over the middle leaves what is far from it dimmer.
float pool(float away) {
    float share = away / poolSize;
    float near = 1.0 / (1.0 + share * share);
    return mix(mix(0.55, 0.86, bright), mix(1.30, 1.04, bright), near);
}

void main() {
    vec2 shade = shadeAt(worldPosition);
    float open = 1.0 - 0.88 * shade.x;
    vec3 key = kKeyColor * (0.36 * keyDirection.y * (1.0 - 0.92 * shade.y) * (1.0 - 0.6 * shade.x));
    float away = distance(worldPosition.xz, floorCenter);
    vec3 light = (key + kSkyColor * open) * pool(away);
    float fade = 1.0 - smoothstep(fadeStart, fadeEnd, away);
    vec3 lit = floorColor(worldPosition.xz) * light;
    // From below, the floor is a pane of glass and blended; from above it is drawn without.
    bool above = eye.y >= worldPosition.y;
    vec3 shown = mix(sky(gl_FragCoord.xy * pixel), lit, above ? fade : 1.0);
    color = vec4(display(shown), above ? 1.0 : 0.25 * fade);
}
