// One direction of a Gaussian blur: wide for the sky, half as wide for the key light.
layout(binding = 0) uniform sampler2D source;
in vec2 uv;
uniform vec2 stride;
out vec4 color;

void main() {
    vec2 sum = vec2(0);
    vec2 weights = vec2(0);
    for (int i = -8; i <= 8; ++i) {
        vec2 w = exp(-0.5 * float(i * i) / vec2(14.0, 4.0));
        sum += w * textureLod(source, uv + float(i) * stride, 0).rg;
        weights += w;
    }
    color = vec4(sum / weights, 0, 1);
}
