// How a surface of a body takes the light: the key light with its shadow, what is around, and what
// comes out again after a way below the skin.
#include "environment.glsl"
#include "light.glsl"
#include "shadow.glsl"

uniform float roughness;
uniform float gloss;
uniform float glow;
uniform float mirrorLevel;  // of the environment, for this roughness
uniform float mirrorReach;  // see mirrored()
uniform float bodySize;     // diagonal at rest [m]
uniform float floorHeight;
uniform float hasFloor;

// GGX lobe with the visibility term folded into a constant.
float highlight(vec3 n, vec3 v) {
    vec3 h = normalize(v + keyDirection);
    float a = roughness * roughness;
    float nh = clamp(dot(n, h), 0.0, 1.0);
    float d = nh * nh * (a * a - 1.0) + 1.0;
    return a * a / (3.14159 * d * d);
}

// Downward faces near the floor see little of the sky.
float openness(vec3 point, vec3 n) {
    if (hasFloor == 0.0) {
        return 1.0;
    }
    float height = max(point.y - floorHeight, 0.0) / (0.16 * bodySize);
    float down = 0.5 - 0.5 * n.y;
    return 1.0 - 0.8 * down * exp(-height);
}

// `facing`: strength of a light from the side of the viewer, so that cut faces read at once from
// anywhere.
vec3 shade(vec3 point, vec3 albedo, vec3 n, vec3 v, float facing) {
    float nl = dot(n, keyDirection);
    float nv = clamp(dot(n, v), 0.0, 1.0);
    float lit = keyVisibility(point, n);
    float direct = max(nl, 0.0);
    float open = openness(point, n);
    // What creeps past the terminator was scattered inside: no sharp shadow cuts it, and the longer
    // its way the purer its colour.
    float wrap = 0.14 + 0.36 * glow;
    float scattered = max((nl + wrap) / (1.0 + wrap), 0.0) - direct;
    vec3 deep = albedo * albedo / max(max(albedo.r, max(albedo.g, albedo.b)), 1e-3);
    vec3 inside = mix(albedo, deep, glow);
    vec3 light = kKeyColor * (albedo * (direct * lit) + (0.22 + 0.28 * glow) * scattered * inside);
    float fill = facing * nv * (1.0 - 0.7 * direct * lit);
    MattLight around = lightFromAround(n);
    light += albedo * (around.front + fill * kFillColor) * open;
    // From behind: most where the way through the body is short, at its outline.
    float through = clamp(-dot(v, keyDirection) * 0.5 + 0.5, 0.0, 1.0);
    float thin = 1.0 - 0.75 * nv;
    light += glow * thin * deep * (0.3 * kKeyColor * through * through + 0.6 * around.back);
    float edge = 1.0 - nv;
    float edge2 = edge * edge;
    float fresnel = gloss * (0.04 + (1.0 - 0.85 * roughness) * 0.5 * edge2 * edge2);
    light += kKeyColor * (0.045 * gloss * min(highlight(n, v), 14.0) * direct * lit);
    return light + mirrored(reflect(-v, n), mirrorLevel, mirrorReach) * (fresnel * open);
}
