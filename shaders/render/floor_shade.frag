// From two depth maps whose depth is the height above the floor: what the body takes from each
// point of the floor, before blurring. x: sky, hidden by what is close above; y: key light.
layout(binding = 0) uniform sampler2D fromBelow;
layout(binding = 1) uniform sampler2D alongKey;
in vec2 uv;
uniform float depthRange;  // [m]
uniform float falloff;     // [m]
out vec4 color;

void main() {
    float height = textureLod(fromBelow, uv, 0).r;
    float occluder = textureLod(alongKey, uv, 0).r;
    float sky = height >= 1.0 ? 0.0 : exp(-height * depthRange / falloff);
    float key = occluder >= 1.0 ? 0.0 : mix(1.0, 0.75, occluder);
    color = vec4(sky, key, 0, 1);
}
