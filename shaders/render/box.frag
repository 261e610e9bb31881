// A box: matt grey under the key light and the sky, with lighter edges that show its shape.
#include "light.glsl"
#include "shadow.glsl"
#include "tone.glsl"
in vec3 worldPosition;
flat in vec3 worldNormal;
in vec2 along;
flat in vec2 sides;
uniform vec3 eye;
uniform float edgeWidth;  // [m]
uniform float hasBody;
out vec4 color;

float edgeCover() {
    vec2 away = min(along, sides - along);
    vec2 pixel = max(fwidth(along), vec2(1e-9));
    vec2 width = min(vec2(edgeWidth), 0.08 * sides);
    vec2 cover = 1.0 - smoothstep(width - pixel, width + pixel, away);
    return max(cover.x, cover.y);
}

void main() {
    vec3 n = normalize(worldNormal);
    vec3 albedo = mix(vec3(0.20, 0.23, 0.28), vec3(0.36, 0.40, 0.46), edgeCover());
    float lit = hasBody > 0.0 ? keyVisibility(worldPosition, n) : 1.0;
    vec3 light = albedo * kKeyColor * max(dot(n, keyDirection), 0.0) * lit;
    float facing = clamp(dot(n, normalize(eye - worldPosition)), 0.0, 1.0);
    light += albedo * (ambientLight(n) + 0.12 * facing * kFillColor);
    color = vec4(display(light), 1);
}
