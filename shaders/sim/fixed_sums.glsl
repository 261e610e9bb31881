#pragma once
// Sums of displacements as integers, which do not mind the order in which threads come: three words
// for d, then three for X, of each vertex, in a unit [m]. The includer declares `sums`.
void addFixed(uint place, float unit, vec3 value) {
    ivec3 steps = ivec3(round(clamp(value / unit, -1e9, 1e9)));
    atomicAdd(sums[place], steps.x);
    atomicAdd(sums[place + 1u], steps.y);
    atomicAdd(sums[place + 2u], steps.z);
}

// To d of a vertex and to its X.
void addToSums(uint v, float unit, vec3 impulse, vec3 push) {
    addFixed(6u * v, unit, impulse);
    addFixed(6u * v + 3u, unit, push);
}

vec3 takeSum(uint place, float unit) {
    vec3 sum = unit * vec3(sums[place], sums[place + 1u], sums[place + 2u]);
    sums[place] = 0;
    sums[place + 1u] = 0;
    sums[place + 2u] = 0;
    return sum;
}
