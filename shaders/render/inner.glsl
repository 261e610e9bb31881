// The walls of a cut, in rest space. PATTERN: 0 pulp, 1 rings, 2 marbling, 3 gel, 4 meat,
// 5 sponge, 6 wood, 7 stone, 8 even.
#include "render_bindings.h"
#include "rest_space.glsl"
#include "solid.glsl"

uniform vec3 innerColor;
uniform vec3 rindColor;
uniform float rindShare;  // of the depth, 0 for none

layout(binding = kUnitDepthField) uniform sampler3D depthField;
uniform float hasDepthField;
uniform vec3 fieldOrigin;
uniform vec3 fieldScale;  // rest metres to texture coordinates

// How deep below the skin: 0 at the skin, 1 at the innermost point of the uncut body.
float depthBelowSkin(vec3 rest) {
    if (hasDepthField > 0.0) {
        return texture(depthField, (rest - fieldOrigin) * fieldScale).r;
    }
    return 1.0 - length((rest - restCenter) / restExtent);
}

float band(float x, float count) {
    float phase = x * count;
    float soft = clamp(fwidth(phase), 0.0, 1.0);
    return (1.0 - soft) * cos(6.2831853 * phase);
}

#if PATTERN == 0
// The axes of an icosahedron, turned so that no plane along the world's axes lies between two.
const vec3 kSegmentAxes[6] = vec3[](vec3(0.0819, 0.3767, 0.9227),
                                   vec3(-0.5897, 0.4981, -0.6358),
                                   vec3(0.0001, 0.9970, 0.0777),
                                   vec3(0.8217, -0.4186, -0.3867),
                                   vec3(0.8725, 0.4305, 0.2315),
                                   vec3(-0.4574, -0.5055, 0.7316));

// How far from the skin between two segments, 0 on it.
float segmentDepth(vec3 outwards) {
    float first = 0.0;
    float second = 0.0;
    for (int i = 0; i < 6; ++i) {
        float along = abs(dot(outwards, kSegmentAxes[i]));
        second = max(second, min(first, along));
        first = max(first, along);
    }
    return first - second;
}

// Juice sacks that point outwards, in segments with pale skins between them and a pale core.
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 away = inUnits(rest);
    float radius = length(away);
    vec3 outwards = away / max(radius, 1e-6);
    float sacks = valueNoise(outwards * 19.0 + 1.1 * depth) - 0.5;
    float broad = valueNoise(outwards * 7.0 - 1.6 * depth) - 0.5;
    vec3 flesh = innerColor * (1.0 + 0.42 * sacks + 0.26 * broad);
    flesh = mix(flesh, flesh * vec3(1.10, 1.0, 0.76), smoothstep(0.1, 0.8, depth));
    float skins = 1.0 - smoothstep(0.012, 0.028, segmentDepth(outwards) * radius);
    float core = 1.0 - smoothstep(0.07, 0.12, radius);
    vec3 pale = min(innerColor * 1.3 + 0.16, vec3(0.9));
    return mix(flesh, pale, max(0.8 * skins, 0.9 * core));
}
#elif PATTERN == 1
// Rings as deep below the skin everywhere, a darker core with seeds, fine fibres.
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    float wobble = 0.04 * (valueNoise(u * 6.0) - 0.5);
    float fibre = valueNoise(u * 34.0) - 0.5;
    vec3 flesh = innerColor * (1.0 + 0.10 * fibre + 0.11 * band(depth + wobble, 6.0));
    float core = smoothstep(0.62, 0.82, depth);
    flesh = mix(flesh, innerColor * vec3(0.80, 0.66, 0.48), 0.75 * core);
    float seed = smoothstep(0.70, 0.80, valueNoise(u * 42.0)) * smoothstep(0.62, 0.72, depth);
    return mix(flesh, vec3(0.10, 0.055, 0.025), 0.7 * seed);
}
#elif PATTERN == 2
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    vec3 warp = vec3(valueNoise(u * 4.0), valueNoise(u * 4.0 + 17.0), valueNoise(u * 4.0 + 41.0));
    float vein = abs(2.0 * valueNoise(u * 5.0 + 2.2 * warp) - 1.0);
    float thin = 1.0 - smoothstep(0.02, 0.20, vein);
    vec3 flesh = innerColor * (0.94 + 0.14 * warp.x);
    return mix(flesh, rindColor, 0.38 * thin);
}
#elif PATTERN == 3
// Clear, with a few bubbles, paler towards the middle.
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    float bubble = smoothstep(0.05, 0.2, holes(u * 4.0, 0.02, 0.22));
    float rim = bubble * (1.0 - smoothstep(0.2, 0.7, holes(u * 4.0, 0.02, 0.22)));
    vec3 flesh = innerColor * (0.9 + 0.25 * valueNoise(u * 2.0) + 0.15 * depth);
    return mix(flesh, rindColor, 0.6 * rim + 0.25 * bubble);
}
#elif PATTERN == 4
vec3 fleshAlbedo(vec3 rest, float depth) {
    return meatColor(inUnits(rest), innerColor, rindColor, 1.0);
}
#elif PATTERN == 5
vec3 fleshAlbedo(vec3 rest, float depth) {
    return spongeColor(inUnits(rest), innerColor, rindColor);
}
#define BUMPS
float heightOf(vec3 rest) {
    float size = max(restExtent.x, max(restExtent.y, restExtent.z));
    return -0.03 * size * spongeHoles(inUnits(rest));
}
#elif PATTERN == 6
vec3 fleshAlbedo(vec3 rest, float depth) {
    return woodColor(inUnits(rest), innerColor, rindColor);
}
#elif PATTERN == 7
vec3 fleshAlbedo(vec3 rest, float depth) {
    return stoneColor(inUnits(rest), innerColor, rindColor);
}
#else
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    return innerColor * (1.0 + 0.10 * (valueNoise(u * 5.0) - 0.5));
}
#endif

// A torn wall by its material: how high it stands, 0 to 1, and what 1 is, as inUnits().
#if PATTERN == 3 || PATTERN == 7
// Shells with ridges between them, as brittle gels and stone break.
const float kTornDepth = 0.03;
float tornHeight(vec3 u) {
    float fold = 2.0 * valueNoise(u * 5.0 + 3.0 * valueNoise(u * 3.0)) - 1.0;
    return sqrt(fold * fold + 0.01);
}
#elif PATTERN == 4 || PATTERN == 6
// Bundles of fibres, pulled out.
const float kTornDepth = 0.03;
float tornHeight(vec3 u) {
    vec3 along = PATTERN == 4 ? vec3(0.15, 1.0, 1.0) : vec3(1.0, 0.1, 1.0);
    return 0.6 * valueNoise(u * 16.0 * along) + 0.4 * valueNoise(u * 37.0 * along + 7.0);
}
#else
// Crumbs.
const float kTornDepth = 0.03;
float tornHeight(vec3 u) {
    return 0.6 * valueNoise(u * 15.0) + 0.4 * valueNoise(u * 34.0 + 7.0);
}
#endif

vec3 innerAlbedo(vec3 rest) {
    float depth = depthBelowSkin(rest);
    vec3 flesh = fleshAlbedo(rest, depth);
    if (rindShare == 0.0) {
        return flesh;
    }
    float soft = max(fwidth(depth), 0.012);
    float rind = 1.0 - smoothstep(rindShare - soft, rindShare + soft, depth);
    float pith = exp(-pow((depth - rindShare - 0.02) / 0.03, 2.0));
    flesh = mix(flesh, min(flesh * 1.35 + 0.06, vec3(0.9)), 0.7 * pith);
    return mix(flesh, rindColor, rind);
}
