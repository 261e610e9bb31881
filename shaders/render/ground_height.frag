// From the depth map seen from below: how much of the sky the lowest surface above a floor point
// hides, before blurring. 1 in contact, falling off with height.
layout(binding = 0) uniform sampler2D heightMap;
in vec2 uv;
uniform float depthRange;  // [m]
uniform float falloff;     // [m]
out vec4 color;

void main() {
    float depth = textureLod(heightMap, uv, 0).r;
    float height = depth * depthRange;
    color = vec4(depth >= 1.0 ? 0.0 : exp(-height / falloff));
}
