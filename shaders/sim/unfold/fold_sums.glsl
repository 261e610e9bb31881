// The sum of the folds of the goals that a vertex is in: its own and those of its neighbours. The
// includer declares `neighbours`, foldAt(v).
#include "members.glsl"

float sumOfFolds(uint v, uvec2 range) {
    float sum = 0.0;
    for (uint i = 0u; i < memberCount(range); ++i) {
        sum += foldAt(memberOf(v, range, i));
    }
    return sum;
}
