// One direction of a Gaussian blur.
layout(binding = 0) uniform sampler2D source;
in vec2 uv;
uniform vec2 stride;
out vec4 color;

void main() {
    float sum = 0.0;
    float weights = 0.0;
    for (int i = -8; i <= 8; ++i) {
        float w = exp(-0.5 * float(i * i) / 14.0);
        sum += w * textureLod(source, uv + float(i) * stride, 0).r;
        weights += w;
    }
    color = vec4(sum / weights);
}
