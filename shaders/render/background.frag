#include "background.glsl"
#include "tone.glsl"
in vec2 uv;
uniform float hasFloor;
out vec4 color;

void main() {
    vec3 backdrop = hasFloor > 0.0 ? sky(uv) : studio(uv);
    color = vec4(display(backdrop), 1);
}
