// Ends the preconditioner's answer to the residual: adds that of the aggregates, each of which
// moves by its modes as the inverse at rest says of the residuals of all aggregates of its piece.
// With OF_PRESSURE it is the answer to dV/dp. Numbers: the slot.
// One group for each aggregate. A storage barrier follows.
#include "sim/numbers.glsl"
#include "sim/implicit/pieces.glsl"
#include "sim/unfold/best_rotation.glsl"
layout(local_size_x = GROUP) in;
STATE_TEXELS(kPositionsBinding) positions;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
STATE_TEXELS(kMemberSharesUnit) memberShares;
STATE_TEXELS(kCoarseUnit) coarse;
STATE_TEXELS(kTurnsUnit) turns;
STATE_TEXELS(kModesBinding) modes;
STATE_TEXELS(kAnswerBinding) answers;
STATE_TEXELS(kGradientsBinding) gradients;
#ifdef OF_PRESSURE
layout(std430, binding = kPressureBinding) writeonly buffer Pressures { vec4 newAnswers[]; };
mat2x3 leftAt(uint v) { return mat2x3(0.0); }
vec3 pressureAt(uint v) { return vec3(0.0); }
#else
STATE_TEXELS(kTotalUnit) totals;  // two texels a vertex, see advance.glsl
STATE_TEXELS(kPressureBinding) pressures;
mat2x3 leftAt(uint v) {
    uint now = (numbers.x + 1u) & 1u;  // of the slot before
    return mat2x3(fetch(totals, 2u * v + now).xyz, fetch(totals, 2u * v + 1u - now).xyz);
}
vec3 pressureAt(uint v) { return fetch(pressures, v).xyz; }
layout(std430, binding = kAnswerBinding) writeonly buffer Answers { vec4 newAnswers[]; };
#endif
layout(std430, binding = kAnswerSumsBinding) writeonly buffer Sums { vec4 newSums[]; };

const uint kParts = 4u;  // of a row, each every fourth aggregate
const uint kSumGroups = 8u;
shared float parts[kAggregateModes * kParts];
// AnswerSums, first texel: a vertex has none of the second. Then the last of its sums.
shared vec4 products[kMostMembers];
shared float lasts[kMostMembers];
shared vec4 productRows[kSumGroups];
shared float lastRows[kSumGroups];

float partOf(uint row, uint part, uvec2 all, uint firstTexel) {
    float sum = 0.0;
    for (uint k = part; k < all.y; k += kParts) {
        uint at = firstTexel + 3u * (row * all.y + k);
        uint from = 3u * (all.x + k);
        sum += dot(fetch(coarse, at), fetch(modes, from));
        sum += dot(fetch(coarse, at + 1u), fetch(modes, from + 1u));
        sum += dot(fetch(coarse, at + 2u), fetch(modes, from + 2u));
    }
    return sum;
}

float modeOf(uint row) {
    uint at = kParts * row;
    return (parts[at] + parts[at + 1u]) + (parts[at + 2u] + parts[at + 3u]);
}

// Along an axis.
vec4 modesOf(uint axis) {
    uint row = 4u * axis;
    return vec4(modeOf(row), modeOf(row + 1u), modeOf(row + 2u), modeOf(row + 3u));
}

void leaveSums(uint count) {
    for (uint row = gl_LocalInvocationID.x; row < kSumGroups; row += GROUP) {
        vec4 sum = vec4(0.0);
        float last = 0.0;
        for (uint k = row; k < count; k += kSumGroups) {
            sum += products[k];
            last += lasts[k];
        }
        productRows[row] = sum;
        lastRows[row] = last;
    }
    barrier();
    if (gl_LocalInvocationID.x == 0u) {
        vec4 sum = vec4(0.0);
        float last = 0.0;
        for (uint row = 0u; row < kSumGroups; ++row) {
            sum += productRows[row];
            last += lastRows[row];
        }
        uint at = 2u * (numbers.x * implicit.aggregate_count + gl_WorkGroupID.x);
        newSums[at] = sum;
        newSums[at + 1u] = vec4(last, 0.0, 0.0, 0.0);
    }
}

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    ImplicitPiece piece = pieceAt(own.z);
    uvec2 all = uvec2(piece.first_aggregate, piece.aggregate_count);
    for (uint task = gl_LocalInvocationID.x; task < kAggregateModes * kParts; task += GROUP) {
        parts[task] = partOf(task / kParts, task % kParts, all, own.w);
    }
    barrier();
    vec4 x = modesOf(0u);
    vec4 y = modesOf(1u);
    vec4 z = modesOf(2u);
    vec4 turn = fetch(turns, implicit.patch_count + gl_WorkGroupID.x);
    uint count = own.y - own.x;
    for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
        uint v = fetch(members, own.x + k).x;
        vec4 shares = vec4(1.0, fetch(memberShares, own.x + k).xyz);
        vec3 moved = rotated(turn, vec3(dot(x, shares), dot(y, shares), dot(z, shares)));
        bool held = !(fetch(positions, v).w > 0.0);
        vec3 answer = held ? vec3(0.0) : fetch(answers, v).xyz + moved;
        newAnswers[v] = vec4(answer, 0.0);
        mat2x3 left = leftAt(v);
        vec3 pressure = pressureAt(v);
        products[k] = vec4(dot(left[0], answer), dot(fetch(gradients, v).xyz, answer),
                           dot(left[1], answer), dot(left[0], pressure));
        lasts[k] = dot(left[1], pressure);
    }
    barrier();
    leaveSums(count);
}
