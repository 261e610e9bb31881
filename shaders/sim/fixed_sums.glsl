// Sums of displacements as integers, which do not mind the order in which threads come: three words
// for d, then three for X, of each vertex. The includer declares `uniforms.unit` [m] and `sums`.
void addFixed(uint place, vec3 value) {
    ivec3 steps = ivec3(round(clamp(value / uniforms.unit, -1e9, 1e9)));
    atomicAdd(sums[place], steps.x);
    atomicAdd(sums[place + 1u], steps.y);
    atomicAdd(sums[place + 2u], steps.z);
}

// To d of a vertex and to its X.
void addToSums(uint v, vec3 impulse, vec3 push) {
    addFixed(6u * v, impulse);
    addFixed(6u * v + 3u, push);
}

vec3 takeSum(uint place) {
    vec3 sum = uniforms.unit * vec3(sums[place], sums[place + 1u], sums[place + 2u]);
    sums[place] = 0;
    sums[place + 1u] = 0;
    sums[place + 2u] = 0;
    return sum;
}
