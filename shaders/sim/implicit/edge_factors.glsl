// A spoke: the texel of its own vertex, then that of the other.
#include "sim/implicit/spring.glsl"
RECORD_WORDS(kSpokeOwnersUnit) owners;

void setFactors(uint place, uint first) {
    Spoke spoke = fetchSpoke(records, place);
    uint own = fetch(owners, place).x;
    bool used = own != kNoVertex;
    vec3 span = placeOf(used ? own : 0u) - placeOf(used ? spoke.other : 0u);
    float stiffness = used ? implicit.modulus[kStretch] / spoke.geometry : 0.0;
    Spring spring = springOf(span, spoke.rest_length, stiffness);
    uint at = first + 2u * place;
    setFactor(at, spring, 1.0);
    setFactor(at + 1u, spring, -1.0);
    setPull(at, spring.pull);
}
