// How much of the light from around reaches each pixel of body and boxes, from the depth of the
// picture alone (McGuire and others, "The Alchemy screen-space ambient obscurance algorithm").
layout(binding = 0) uniform sampler2D depths;
in vec2 uv;
uniform mat4 clipToWorld;
uniform mat4 viewProjection;
uniform vec3 eye;
uniform float reach;  // [m]
out vec4 color;

const int kTaps = 16;

vec3 pointAt(ivec2 wanted, vec2 size) {
    ivec2 pixel = clamp(wanted, ivec2(0), ivec2(size) - 1);
    float depth = texelFetch(depths, pixel, 0).r;
    vec4 p = clipToWorld * vec4((vec2(pixel) + 0.5) / size * 2.0 - 1.0, depth * 2.0 - 1.0, 1);
    return p.xyz / p.w;
}

// The shorter of two steps: the other one may lead over an edge. At the border of the picture one
// leads nowhere.
vec3 shorter(vec3 a, vec3 b) {
    float sizeA = dot(a, a);
    float sizeB = dot(b, b);
    return sizeB == 0.0 || (sizeA > 0.0 && sizeA < sizeB) ? a : b;
}

// Turns the taps from pixel to pixel, in a pattern of 4x4 that the blur evens out.
float turnOf(ivec2 pixel) {
    return float((pixel.x & 3) * 4 + ((pixel.y ^ pixel.x) & 3)) * (6.2831853 / 16.0);
}

void main() {
    vec2 size = vec2(textureSize(depths, 0));
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(depths, pixel, 0).r >= 1.0) {
        color = vec4(1);
        return;
    }
    vec3 p = pointAt(pixel, size);
    const ivec2 right = ivec2(1, 0);
    const ivec2 up = ivec2(0, 1);
    vec3 dx = shorter(pointAt(pixel + right, size) - p, p - pointAt(pixel - right, size));
    vec3 dy = shorter(pointAt(pixel + up, size) - p, p - pointAt(pixel - up, size));
    vec3 n = normalize(cross(dx, dy));
    vec3 side = normalize(cross(eye - p, vec3(0.31, 0.87, 0.38)));
    vec4 aside = viewProjection * vec4(p + reach * side, 1);
    float radius = clamp(length((aside.xy / aside.w * 0.5 + 0.5 - uv) * size), 3.0, 0.15 * size.y);
    float sum = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        float share = (float(i) + 0.5) / float(kTaps);
        float angle = 2.39996323 * float(i) + turnOf(pixel);
        ivec2 tap = pixel + ivec2(share * radius * vec2(cos(angle), sin(angle)));
        vec3 v = pointAt(tap, size) - p;
        float d = dot(v, v);
        float fade = max(1.0 - d / (reach * reach), 0.0);
        sum += fade * max(dot(v, n) - 0.02 * reach, 0.0) / (sqrt(d) + 0.04 * reach);
    }
    color = vec4(vec3(clamp(1.0 - 1.9 * sum / float(kTaps), 0.0, 1.0)), 1);
}
