// The floor: matt, shadowed, with an anti-aliased grid that fades into the backdrop.
#include "light.glsl"
#include "tone.glsl"

layout(binding = kUnitGround) uniform sampler2D groundOcclusion;

in vec3 worldPosition;
uniform vec3 eye;
uniform float cell;        // side of a small grid cell [m]
uniform vec2 floorCenter;
uniform float fadeStart;   // [m] from floorCenter
uniform float fadeEnd;     // [m]
uniform mat4 groundMatrix; // world to the contact map
uniform float hasBody;
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

float contactShade(vec3 point) {
    vec2 uv = (groundMatrix * vec4(point, 1)).xy * 0.5 + 0.5;
    if (any(lessThan(uv, vec2(0))) || any(greaterThan(uv, vec2(1)))) {
        return 1.0;
    }
    return 1.0 - 0.86 * textureLod(groundOcclusion, uv, 0).r;
}

vec3 floorColor() {
    vec2 p = worldPosition.xz;
    vec2 pixel = fwidth(p);
    vec3 albedo = vec3(0.052, 0.058, 0.070);
    float small = gridCover(p / cell, pixel / cell, 0.016);
    float large = gridCover(p / (5.0 * cell), pixel / (5.0 * cell), 0.0075);
    albedo = mix(albedo, vec3(0.115, 0.125, 0.145), 0.55 * small);
    albedo = mix(albedo, vec3(0.17, 0.185, 0.215), 0.75 * large);
    albedo = mix(albedo, vec3(0.42, 0.09, 0.08), 0.85 * axisCover(p.y, pixel.y, 0.018 * cell));
    albedo = mix(albedo, vec3(0.08, 0.16, 0.46), 0.85 * axisCover(p.x, pixel.x, 0.018 * cell));
    return albedo;
}

void main() {
    vec3 n = vec3(0, 1, 0);
    float lit = hasBody > 0.0 ? keyVisibility(worldPosition, n) : 1.0;
    float open = hasBody > 0.0 ? contactShade(worldPosition) : 1.0;
    float facing = keyDirection.y;
    vec3 light = kKeyColor * facing * 0.36 * lit * mix(open, 1.0, 0.35) + kSkyColor * 1.05 * open;
    float away = distance(worldPosition.xz, floorCenter);
    float fade = 1.0 - smoothstep(fadeStart, fadeEnd, away);
    // From below, the floor is a pane of glass.
    float opacity = eye.y >= worldPosition.y ? fade : 0.25 * fade;
    color = vec4(display(floorColor() * light), opacity);
}
