// An ISPC: see constraints/ispc.glsl and ConstraintPull.
#include "sim/implicit/spring.glsl"

void setFactors(uint index, uint first) {
    uvec4 corners = fetch(records, 2u * index);
    vec4 rest = uintBitsToFloat(fetch(records, 2u * index + 1u));  // b1, b2, length, geometry
    float b0 = 1.0 - rest.x - rest.y;
    vec4 x = fetch(positions, corners.x);
    vec4 a = fetch(positions, corners.y);
    vec4 b = fetch(positions, corners.z);
    vec4 c = fetch(positions, corners.w);
    vec3 span = b0 * (x.xyz - a.xyz) + rest.x * (x.xyz - b.xyz) + rest.y * (x.xyz - c.xyz);
    float moved = x.w + b0 * b0 * a.w + rest.x * rest.x * b.w + rest.y * rest.y * c.w;
    float stiffness = boundedFirmness(implicit.modulus[kIspc] / rest.w, moved);
    Spring spring = springOf(span, rest.z, stiffness);
    uint at = first + 4u * index;
    setFactor(at, spring, 1.0);
    setFactor(at + 1u, spring, -b0);
    setFactor(at + 2u, spring, -rest.x);
    setFactor(at + 3u, spring, -rest.y);
    setPull(at, spring.pull);
}
