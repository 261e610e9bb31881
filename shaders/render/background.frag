#include "background.glsl"
#include "tone.glsl"
in vec2 uv;
uniform float glow;
out vec4 color;

void main() { color = vec4(display(backdrop(uv, glow)), 1); }
