// Smooths stair steps where there is no multisampling: where neighbours differ in brightness, blurs
// along the edge that they form, further where it runs nearly level or upright (the idea of
// Lottes' FXAA).
layout(binding = 0) uniform sampler2D picture;
out vec4 color;

const float kReach = 6.0;       // [px]
const float kThreshold = 0.06;  // brightness difference that makes an edge

float brightness(vec3 c) { return dot(c, vec3(0.30, 0.59, 0.11)); }

float neighbour(ivec2 pixel, ivec2 offset) {
    return brightness(texelFetch(picture, pixel + offset, 0).rgb);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 own = texelFetch(picture, pixel, 0).rgb;
    float nw = neighbour(pixel, ivec2(-1, 1));
    float ne = neighbour(pixel, ivec2(1, 1));
    float sw = neighbour(pixel, ivec2(-1, -1));
    float se = neighbour(pixel, ivec2(1, -1));
    float low = min(min(nw, ne), min(sw, se));
    float high = max(max(nw, ne), max(sw, se));
    vec2 along = vec2(sw + se - nw - ne, nw + sw - ne - se);
    float shorter = min(abs(along.x), abs(along.y)) + 0.05 * (nw + ne + sw + se) + 0.008;
    vec2 size = vec2(textureSize(picture, 0));
    vec2 reach = clamp(along / shorter, -kReach, kReach) / size;
    vec2 uv = gl_FragCoord.xy / size;
    vec3 near = 0.5 * (textureLod(picture, uv - reach / 6.0, 0).rgb +
                       textureLod(picture, uv + reach / 6.0, 0).rgb);
    vec3 far = 0.25 * (textureLod(picture, uv - reach / 2.0, 0).rgb +
                       textureLod(picture, uv + reach / 2.0, 0).rgb) + 0.5 * near;
    float farBrightness = brightness(far);
    bool leavesRange = farBrightness < min(low, brightness(own)) ||
        farBrightness > max(high, brightness(own));
    vec3 smoothed = leavesRange ? near : far;
    color = vec4(high - low > kThreshold ? smoothed : own, 1);
}
