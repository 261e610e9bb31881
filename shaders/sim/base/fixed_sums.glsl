#pragma once
// Sums of vectors as integers, which do not mind the order in which threads come: three words each,
// in a unit [m]. The includer declares `sums`.
void addFixed(uint place, float unit, vec3 value) {
    ivec3 steps = ivec3(round(clamp(value / unit, -1e9, 1e9)));
    atomicAdd(sums[place], steps.x);
    atomicAdd(sums[place + 1u], steps.y);
    atomicAdd(sums[place + 2u], steps.z);
}

vec3 sumAt(uint place, float unit) {
    return unit * vec3(sums[place], sums[place + 1u], sums[place + 2u]);
}

vec3 takeSum(uint place, float unit) {
    vec3 sum = sumAt(place, unit);
    sums[place] = 0;
    sums[place + 1u] = 0;
    sums[place + 2u] = 0;
    return sum;
}
