// What a section plane shows of the inside: as the look has it there, or with PLAIN in grey. Light
// without shadows, since what is hidden would cast them.
#include "light.glsl"
#include "tone.glsl"
#ifndef PLAIN
#include "inner.glsl"
#endif

in vec3 worldPosition;

uniform vec3 sectionNormal;  // towards the eye
uniform vec3 bodyCenter;     // of the body as it is [m]
uniform vec3 bodyExtent;     // half sides of its box [m]
uniform float wholeBody;     // 1: one piece, about as it lay at rest
out vec4 color;

vec3 sectionAlbedo() {
#ifdef PLAIN
    return vec3(0.30);
#else
    vec3 rest = restCenter + (worldPosition - bodyCenter) / bodyExtent * restExtent;
    return wholeBody > 0.0 ? innerAlbedo(rest) : fleshAlbedo(rest, 0.5);
#endif
}

void main() {
    float direct = max(dot(sectionNormal, keyDirection), 0.0);
    vec3 light = kKeyColor * (0.25 + 0.35 * direct) + ambientLight(sectionNormal);
    color = vec4(display(sectionAlbedo() * light), 1);
}
