// Mean of 4x4 pixels, those alone that lie about as deep. Multiplied into the picture.
layout(binding = 0) uniform sampler2D depths;
layout(binding = 1) uniform sampler2D open;
in vec2 uv;
uniform float strength;
out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(depths, 0) - 1;
    float depth = texelFetch(depths, pixel, 0).r;
    float slope = 2.0 * fwidth(depth) + 1e-5;
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -2; y < 2; ++y) {
        for (int x = -2; x < 2; ++x) {
            ivec2 tap = clamp(pixel + ivec2(x, y), ivec2(0), last);
            float away = abs(texelFetch(depths, tap, 0).r - depth);
            float weight = away < 4.0 * slope ? 1.0 : 0.0;
            sum += weight * texelFetch(open, tap, 0).r;
            weights += weight;
        }
    }
    float light = weights > 0.0 ? sum / weights : 1.0;
    color = vec4(vec3(mix(1.0, light, strength)), 1);
}
