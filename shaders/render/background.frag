#include "background.glsl"
#include "tone.glsl"
in vec2 uv;
uniform float hasFloor;
uniform mat4 pictureToWorld;  // from clip space, around the eye
out vec4 color;

void main() {
    vec4 ray = pictureToWorld * vec4(uv * 2.0 - 1.0, 1, 1);
    vec3 backdrop = hasFloor > 0.0 ? sky(normalize(ray.xyz / ray.w).y) : studio(uv);
    color = vec4(display(backdrop), 1);
}
