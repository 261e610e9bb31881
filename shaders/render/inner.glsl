// The walls of a cut, in rest space. PATTERN: 0 pulp, 1 rings, 2 marbling.
#include "render_bindings.h"
#include "rest_space.glsl"

uniform vec3 innerColor;
uniform vec3 rindColor;

layout(binding = kUnitDepthField) uniform sampler3D depthField;
uniform float hasDepthField;
uniform vec3 fieldOrigin;
uniform vec3 fieldScale;  // rest metres to texture coordinates

const float kRindShare = 0.11;

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
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    float fibre = valueNoise(u * 34.0) - 0.5;
    vec3 flesh = innerColor * (1.0 + 0.10 * fibre + 0.045 * band(depth, 4.0));
    float core = smoothstep(0.62, 0.82, depth);
    flesh = mix(flesh, innerColor * vec3(0.80, 0.66, 0.48), 0.75 * core);
    float seed = smoothstep(0.70, 0.80, valueNoise(u * 42.0)) * smoothstep(0.62, 0.72, depth);
    return mix(flesh, vec3(0.10, 0.055, 0.025), 0.7 * seed);
}
#elif PATTERN == 1
vec3 fleshAlbedo(vec3 rest, float depth) {
    float wobble = 0.05 * (valueNoise(inUnits(rest) * 3.0) - 0.5);
    vec3 flesh = innerColor * (1.0 + 0.15 * band(depth + wobble, 7.0));
    return mix(flesh, flesh * vec3(1.22, 1.16, 1.05), smoothstep(0.35, 1.0, depth));
}
#else
vec3 fleshAlbedo(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    vec3 warp = vec3(valueNoise(u * 4.0), valueNoise(u * 4.0 + 17.0), valueNoise(u * 4.0 + 41.0));
    float vein = abs(2.0 * valueNoise(u * 5.0 + 2.2 * warp) - 1.0);
    float thin = 1.0 - smoothstep(0.02, 0.20, vein);
    vec3 flesh = innerColor * (0.94 + 0.14 * warp.x);
    return mix(flesh, rindColor, 0.38 * thin);
}
#endif

vec3 innerAlbedo(vec3 rest) {
    float depth = depthBelowSkin(rest);
    vec3 flesh = fleshAlbedo(rest, depth);
    float soft = max(fwidth(depth), 0.012);
    float rind = 1.0 - smoothstep(kRindShare - soft, kRindShare + soft, depth);
    float pith = exp(-pow((depth - kRindShare - 0.02) / 0.03, 2.0));
    flesh = mix(flesh, min(flesh * 1.35 + 0.06, vec3(0.9)), 0.7 * pith);
    return mix(flesh, rindColor, rind);
}
