#pragma once
// How contacts share the mass of a vertex: each in proportion to how much it moves it (its gain),
// so that a contact takes nothing of a corner that it hardly touches. Summed as integers, which do
// not mind the order in which threads come.
const float kShareSteps = 65536.0;

uint shareOf(float gain) {
    return uint(ceil(kShareSteps * min(abs(gain), 1024.0)));
}

// What a vertex of which contacts took `taken` in all adds to the weight of one of them, times its
// inverse mass: gain^2 / (|gain| / sum).
float sharedWeight(float gain, uint taken) {
    return abs(gain) * (float(taken) / kShareSteps);
}
