// For kerf doctor: barriers in forms that drivers got wrong, each with one answer, the same for all
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

void main() {
    const uint self = gl_LocalInvocationIndex;
    answers[self] = countInTurns(self);
    answers[kThreads + self] = sumInBranch(self);
}
