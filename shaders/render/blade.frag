// Brushed steel: reflects the backdrop and the key light; the ground bevel is brighter.
#include "light.glsl"
#include "tone.glsl"
in vec3 worldPosition;
in vec3 worldNormal;
in float height;
in float shine;
uniform vec3 eye;
uniform vec3 spine;  // from the edge to the back, unit
out vec4 color;

const float kHollow = 0.55;

// Scratches of the grinding, along the edge.
float scratches(float at) {
    float row = at * 46.0;
    float wide = fwidth(row);
    float lines = fract(sin(floor(row) * 12.9898) * 43758.5453) - 0.5;
    return lines * clamp(1.2 - wide, 0.0, 1.0);
}

vec3 surroundings(vec3 r) {
    // A dark floor, a bright horizon, a dimmer sky: the bands that make metal read as metal.
    vec3 c = mix(vec3(0.05, 0.055, 0.065), vec3(0.30, 0.35, 0.43), smoothstep(-0.5, 0.9, r.y));
    c += vec3(0.34, 0.36, 0.40) * exp(-10.0 * r.y * r.y);
    float key = clamp(dot(r, keyDirection), 0.0, 1.0);
    return c + kKeyColor * (0.9 * pow(key, 24.0) + 0.18 * pow(key, 3.0));
}

void main() {
    vec3 v = normalize(eye - worldPosition);
    vec3 n = normalize(worldNormal);
    n = dot(n, v) < 0.0 ? -n : n;
    // Ground a little hollow: what it mirrors changes from the edge to the back.
    n = normalize(n + spine * (kHollow * (height - 0.5)));
    vec3 steel = vec3(0.74, 0.78, 0.82);
    vec3 light = steel * surroundings(reflect(-v, n));
    light += steel * 0.12 * (ambientLight(n) + kKeyColor * max(dot(n, keyDirection), 0.0));
    light *= mix(mix(1.05, 0.55, height), 1.5, shine) * (1.0 + 0.13 * scratches(height));
    light +=
        vec3(0.9, 1.0, 1.0) * exp(-70.0 * height) + vec3(0.05, 0.5, 0.42) * exp(-22.0 * height);
    color = vec4(display(light), 1);
}
