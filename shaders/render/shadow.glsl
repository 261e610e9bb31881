// The key light's shadow map.
#include "render_bindings.h"

layout(binding = kUnitShadow) uniform sampler2D shadowMap;

uniform mat4 lightMatrix;   // world to the shadow map's clip space
uniform float shadowTexel;  // [m]

// 2x2 bilinear comparison: 1 lit, 0 in shadow.
float shadowTap(vec2 uv, float depth, vec2 size) {
    vec2 texel = uv * size - 0.5;
    vec2 base = floor(texel);
    vec2 f = texel - base;
    vec4 lit = step(vec4(depth), textureGather(shadowMap, (base + 1.0) / size));
    return mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
}

#ifdef SOFT_SHADOWS
const float kLift = 2.0;  // the texels have half the size
const int kSearchTaps = 12;
const int kFilterTaps = 20;

vec2 disk(int i, int count) {
    float r = sqrt((float(i) + 0.5) / float(count));
    float angle = 2.39996323 * float(i);
    return r * vec2(cos(angle), sin(angle));
}

// How far in front of the receiver the occluders lie, as a share of the light's depth range.
float occluderGap(vec2 uv, float depth, float reach) {
    float sum = 0.0;
    float count = 0.0;
    for (int i = 0; i < kSearchTaps; ++i) {
        float d = textureLod(shadowMap, uv + reach * disk(i, kSearchTaps), 0).r;
        sum += d < depth ? depth - d : 0.0;
        count += d < depth ? 1.0 : 0.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

// The penumbra widens with the distance between occluder and receiver.
float filterShadow(vec2 uv, float depth, vec2 size) {
    float reach = clamp(0.16 * occluderGap(uv, depth, 14.0 / 1024.0), 1.5 / size.x, 20.0 / 1024.0);
    float lit = 0.0;
    for (int i = 0; i < kFilterTaps; ++i) {
        lit += shadowTap(uv + reach * disk(i, kFilterTaps), depth, size);
    }
    return lit / float(kFilterTaps);
}
#else
const float kLift = 1.0;

float filterShadow(vec2 uv, float depth, vec2 size) {
    vec2 t = 1.3 / size;
    return 0.25 * (shadowTap(uv + t * vec2(-0.4, -1), depth, size) +
                   shadowTap(uv + t * vec2(1, -0.4), depth, size) +
                   shadowTap(uv + t * vec2(0.4, 1), depth, size) +
                   shadowTap(uv + t * vec2(-1, 0.4), depth, size));
}
#endif

// 1 in the light, 0 in the shadow. The point is lifted off its surface by a few texels, more where
// the light grazes.
float keyVisibility(vec3 point, vec3 n) {
    float grazing = 1.0 - clamp(dot(n, keyDirection), 0.0, 1.0);
    vec3 lifted = point + n * shadowTexel * kLift * (1.2 + 3.0 * grazing);
    vec3 clip = (lightMatrix * vec4(lifted, 1)).xyz;
    vec2 uv = clip.xy * 0.5 + 0.5;
    if (any(lessThan(uv, vec2(0.005))) || any(greaterThan(uv, vec2(0.995)))) {
        return 1.0;
    }
    float depth = min(clip.z * 0.5 + 0.5, 0.9999) - 0.0006;
    return filterShadow(uv, depth, vec2(textureSize(shadowMap, 0)));
}
