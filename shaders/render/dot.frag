// A dot with a dark rim: seen on any ground.
noperspective in vec2 place;
uniform float radius;  // [px]
uniform vec3 tone;
uniform float strength;
out vec4 color;

void main() {
    float away = length(place);
    float cover = clamp(radius + 0.5 - away, 0.0, 1.0);
    float rim = clamp(away - (radius - 1.5), 0.0, 1.0);
    color = vec4(mix(tone, vec3(0.05), 0.8 * rim), strength * cover);
}
