// Brushed steel: reflects the backdrop and the key light; the ground bevel is brighter.
#include "light.glsl"
#include "tone.glsl"
in vec3 worldPosition;
in vec3 worldNormal;
in float height;
in float shine;
uniform vec3 eye;
out vec4 color;

vec3 surroundings(vec3 r) {
    vec3 c = mix(vec3(0.11, 0.12, 0.14), vec3(0.42, 0.48, 0.58), smoothstep(-0.4, 0.9, r.y));
    float key = clamp(dot(r, keyDirection), 0.0, 1.0);
    return c + kKeyColor * (0.9 * pow(key, 24.0) + 0.18 * pow(key, 3.0));
}

void main() {
    vec3 v = normalize(eye - worldPosition);
    vec3 n = normalize(worldNormal);
    n = dot(n, v) < 0.0 ? -n : n;
    vec3 steel = vec3(0.74, 0.78, 0.82);
    vec3 light = steel * surroundings(reflect(-v, n));
    light += steel * 0.12 * (ambientLight(n) + kKeyColor * max(dot(n, keyDirection), 0.0));
    light *= mix(mix(0.95, 0.5, height), 1.4, shine);
    light += vec3(0.05, 0.55, 0.45) * exp(-28.0 * height);
    color = vec4(display(light), 1);
}
