// Light from all around: what a surface mirrors, and what a matt one takes.
#include "render_bindings.h"

layout(binding = kUnitEnvironment) uniform sampler2D environment;
uniform vec3 mattLight[4];  // constant, then by x, y and z of the normal

const float kEnvironmentRange = 8.0;

// Where a direction lies on an unfolded octahedron, each -1 to 1.
vec2 octahedral(vec3 d) {
    vec2 p = d.xz / (abs(d.x) + abs(d.y) + abs(d.z));
    vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
    return d.y < 0.0 ? (1.0 - abs(p.yx)) * signs : p;
}

// `reach`: of the middles of the outermost texels of the level, which meet at the seams.
vec3 mirrored(vec3 direction, float level, float reach) {
    vec3 root = textureLod(environment, 0.5 * reach * octahedral(direction) + 0.5, level).rgb;
    return kEnvironmentRange * root * root;
}

// The lamps of the studio stand where the key light is, which the body takes besides.
const float kMattShare = 0.75;

struct MattLight {
    vec3 front;
    vec3 back;  // of what faces the other way
};

MattLight lightFromAround(vec3 n) {
    vec3 even = kMattShare * mattLight[0];
    vec3 turned =
        kMattShare * (n.x * mattLight[1] + n.y * mattLight[2] + n.z * mattLight[3]);
    return MattLight(max(even + turned, vec3(0)), max(even - turned, vec3(0)));
}
