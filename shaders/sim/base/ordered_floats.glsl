#pragma once
// Words that compare as unsigned integers as their floats do, for atomicMin and atomicMax.
uint orderedWord(float value) {
    uint bits = floatBitsToUint(value);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float orderedFloat(uint word) {
    return uintBitsToFloat((word & 0x80000000u) != 0u ? word & 0x7fffffffu : ~word);
}

// Whether all components lie within a limit. By bits, since compilers are free to turn a comparison
// round where NaN would answer differently.
bool within(vec3 a, float limit) {
    return all(lessThan(floatBitsToUint(a) & 0x7fffffffu, uvec3(floatBitsToUint(limit))));
}
