// What the body is made of, in rest space: it stays attached whatever the body does.
#include "noise.glsl"

uniform vec3 skinColor;
uniform vec3 innerColor;
uniform vec3 rindColor;
uniform int pattern;       // 0 pulp, 1 rings, 2 marbling
uniform float mottle;      // strength of the skin's broad variation
uniform float spots;       // strength of the spots on the skin
uniform vec3 restCenter;
uniform vec3 restExtent;   // half sides of the rest bounds [m]

layout(binding = kUnitDepthField) uniform sampler3D depthField;
uniform float hasDepthField;
uniform vec3 fieldOrigin;
uniform vec3 fieldScale;   // rest metres to texture coordinates

const float kRindShare = 0.11;

vec3 inUnits(vec3 rest) { return (rest - restCenter) / max(restExtent.x, max(restExtent.y, restExtent.z)); }

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

vec3 ringed(vec3 rest, float depth) {
    float wobble = 0.05 * (valueNoise(inUnits(rest) * 3.0) - 0.5);
    vec3 flesh = innerColor * (1.0 + 0.10 * band(depth + wobble, 7.0));
    return mix(flesh, flesh * vec3(1.22, 1.16, 1.05), smoothstep(0.35, 1.0, depth));
}

vec3 pulpy(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    float fibre = valueNoise(u * 34.0) - 0.5;
    vec3 flesh = innerColor * (1.0 + 0.10 * fibre + 0.045 * band(depth, 4.0));
    float core = smoothstep(0.62, 0.82, depth);
    flesh = mix(flesh, innerColor * vec3(0.80, 0.66, 0.48), 0.75 * core);
    float seed = smoothstep(0.70, 0.80, valueNoise(u * 42.0)) * smoothstep(0.62, 0.72, depth);
    return mix(flesh, vec3(0.10, 0.055, 0.025), 0.7 * seed);
}

vec3 marbled(vec3 rest, float depth) {
    vec3 u = inUnits(rest);
    vec3 warp = vec3(valueNoise(u * 4.0), valueNoise(u * 4.0 + 17.0), valueNoise(u * 4.0 + 41.0));
    float vein = abs(2.0 * valueNoise(u * 5.0 + 2.2 * warp) - 1.0);
    float thin = 1.0 - smoothstep(0.02, 0.20, vein);
    vec3 flesh = innerColor * (0.94 + 0.14 * warp.x);
    return mix(flesh, rindColor, 0.38 * thin);
}

vec3 innerAlbedo(vec3 rest) {
    float depth = depthBelowSkin(rest);
    vec3 flesh = pattern == 0 ? pulpy(rest, depth)
                              : (pattern == 1 ? ringed(rest, depth) : marbled(rest, depth));
    float soft = max(fwidth(depth), 0.012);
    float rind = 1.0 - smoothstep(kRindShare - soft, kRindShare + soft, depth);
    float pith = exp(-pow((depth - kRindShare - 0.02) / 0.03, 2.0));
    flesh = mix(flesh, min(flesh * 1.35 + 0.06, vec3(0.9)), 0.7 * pith);
    return mix(flesh, rindColor, rind);
}

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

vec3 skinAlbedo(vec3 rest) {
    vec3 u = inUnits(rest);
    vec3 c = skinColor * (1.0 + mottle * (valueNoise(u * 3.5) - 0.5));
    if (spots > 0.0) {
        c = mix(c, c * vec3(0.42, 0.34, 0.34), spots * spotCover(u * 9.0));
    }
    return c;
}
