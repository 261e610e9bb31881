// An ISPC: see constraints/ispc.glsl and ConstraintPull.
#include "sim/implicit/spring.glsl"

void setFactors(uint index, uint first) {
    uvec4 corners = fetch(records, 2u * index);
    vec4 rest = uintBitsToFloat(fetch(records, 2u * index + 1u));  // b1, b2, length, geometry
    float b0 = 1.0 - rest.x - rest.y;
    vec3 x = placeOf(corners.x);
    vec3 span = b0 * (x - placeOf(corners.y)) + rest.x * (x - placeOf(corners.z)) +
        rest.y * (x - placeOf(corners.w));
    Spring spring = springOf(span, rest.z, implicit.modulus[kIspc] / rest.w);
    uint at = first + 4u * index;
    setFactor(at, spring, 1.0);
    setFactor(at + 1u, spring, -b0);
    setFactor(at + 2u, spring, -rest.x);
    setFactor(at + 3u, spring, -rest.y);
    setPull(at, spring.pull);
}
