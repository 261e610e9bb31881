// For kerf doctor: forms of kernels that drivers got wrong, each with one answer, the same for all
// threads.
#include "sim/base/numbers.glsl"  // x: kThreads, which no compiler knows
const uint kThreads = 128u;
layout(local_size_x = kThreads) in;
layout(std430, binding = 0) buffer Answers { uint answers[]; };
shared uint counted;
shared uint sums[kThreads];

// Each thread counts in its turn: kThreads.
uint countInTurns(uint self) {
    if (self == 0u) counted = 0u;
    barrier();
    for (uint i = 0u; i < numbers.x; ++i) {
        if (self == i) ++counted;
        memoryBarrierShared();
        barrier();
    }
    return counted;
}

// Barriers in a branch and a loop that all threads take: kThreads.
uint sumInBranch(uint self) {
    sums[self] = 1u;
    if (numbers.x != 0u) {
        for (uint part = numbers.x / 2u;; part /= 2u) {
            memoryBarrierShared();
            barrier();
            if (part == 0u) break;
            if (self < part) sums[self] += sums[self + part];
        }
    }
    return sums[0];
}

void turn(inout uint list[4]) {
    const uint first = list[0];
    for (uint i = 0u; i < 3u; ++i) list[i] = list[i + 1u];
    list[3] = first;
}

// A list that is turned as often as its thread's number: its first element, 11.
uint turnList(uint self) {
    uint list[4] = uint[4](11u, 12u, 13u, 14u);
    for (uint i = 0u; i < self; ++i) turn(list);
    return list[(4u - self % 4u) % 4u];
}

void swapColumns(inout mat4 m, uint i, uint j) {
    const vec4 column = m[i];
    m[i] = m[j];
    m[j] = column;
}

// Elements of a matrix, each 16 and its place, less the place, after a swap: 16.
uint swapInMatrix(uint self) {
    mat4 m;
    for (uint i = 0u; i < 16u; ++i) m[i / 4u][i % 4u] = float(16u + i);
    const uint from = self % 4u, to = self / 4u % 4u, row = self / 16u % 4u;
    swapColumns(m, from, to);
    return uint(m[to][row]) - (4u * from + row);
}

void main() {
    const uint self = gl_LocalInvocationIndex;
    answers[self] = countInTurns(self);
    answers[kThreads + self] = sumInBranch(self);
    answers[2u * kThreads + self] = turnList(self);
    answers[3u * kThreads + self] = swapInMatrix(self);
}
