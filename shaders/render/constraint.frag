// A line whose colour the vertices tell.
noperspective in float across;
in vec3 tone;
uniform float width;  // [px]
uniform float strength;
out vec4 color;

void main() {
    float cover = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
    color = vec4(tone, strength * cover);
}
