// Blended by the minimum of what is there and this: where lines overlap they get no darker.
noperspective in float across;
uniform float width;     // [px]
uniform float strength;
out vec4 color;

void main() {
    float cover = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
    color = vec4(vec3(1.0 - strength * cover), 1);
}
