// Light from all around: what a surface mirrors, and what a matt one takes.
#include "render_bindings.h"

layout(binding = kUnitEnvironment) uniform sampler2D environment;
uniform vec3 mattLight[4];  // constant, then by x, y and z of the normal

const float kEnvironmentRange = 8.0;

// Where a direction lies on an unfolded octahedron, 0 to 1.
vec2 octahedral(vec3 d) {
    vec2 p = d.xz / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    p = d.y < 0.0 ? (1.0 - abs(p.yx)) * signs : p;
    return 0.5 * p + 0.5;
}

vec3 mirrored(vec3 direction, float level) {
    vec3 root = textureLod(environment, octahedral(direction), level).rgb;
    return kEnvironmentRange * root * root;
}

// The lamps of the studio stand where the key light is, which the body takes besides.
const float kMattShare = 0.75;

vec3 lightFromAround(vec3 n) {
    vec3 light =
        mattLight[0] + n.x * mattLight[1] + n.y * mattLight[2] + n.z * mattLight[3];
    return kMattShare * max(light, vec3(0));
}
