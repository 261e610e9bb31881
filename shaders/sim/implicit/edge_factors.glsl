// A spoke: the texel of its own vertex, then that of the other.
#include "sim/implicit/spring.glsl"
RECORD_WORDS(kSpokeOwnersUnit) owners;

void setFactors(uint place, uint first) {
    Spoke spoke = fetchSpoke(records, place);
    uint own = fetch(owners, place).x;
    bool used = own != kNoVertex;
    vec4 from = fetch(positions, used ? own : 0u);
    vec4 to = fetch(positions, used ? spoke.other : 0u);
    vec3 span = from.xyz - to.xyz;
    float stiffness =
        used ? boundedFirmness(implicit.modulus[kStretch] / spoke.geometry, from.w + to.w) : 0.0;
    Spring spring = springOf(span, spoke.rest_length, stiffness);
    uint at = first + 2u * place;
    setFactor(at, spring, 1.0);
    setFactor(at + 1u, spring, -1.0);
    setPull(at, spring.pull);
}
