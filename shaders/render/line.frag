noperspective in float across;
uniform float width;  // [px]
uniform vec4 tint;
out vec4 color;

void main() {
    float cover = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
    color = vec4(tint.rgb, tint.a * cover);
}
