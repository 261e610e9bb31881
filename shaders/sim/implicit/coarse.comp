// Ends the preconditioner's answer to the residual: adds that of the aggregates, each of which
// moves by its modes as the inverse at rest says of the residuals of all aggregates of its piece;
// with OF_REGIONS as that of its own residual says, and as its region moves.
// With OF_PRESSURE it is the answer to dV/dp. Else finds how the iterations go on.
// Numbers: the slot, and from which one on they may end. One group for each aggregate. A storage
// barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/last_group.glsl"

// How the iterations of pieces that touch go on: see Course.

const float kRounding = 1e-8;  // of the scale

// Of all that touch.
struct Answered {
    float left;    // left . z
    float size;    // without a change of volume
    float turned;  // the same of what was left before
    float moved;   // the energy of the motion
};

float swellingOf(ImplicitPiece piece, TwoSums now, uint slot) {
    return ratio(now.first.y, knownOf(piece, slot - 1u).z);
}

Answered answered(uint root, uint slot) {
    Answered all = Answered(0.0, 0.0, 0.0, 0.0);
    for (uint p = root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        TwoSums now = sumOfAnswers(piece, slot);
        float swelling = swellingOf(piece, now, slot);
        all.left += now.first.x;
        all.size += now.first.x - swelling * now.first.w;
        all.turned += now.first.z - swelling * now.second.x;
        if (slot == kFirstSlot) all.moved += sumOfProducts(piece, kStartSlot).first.w;
        if (gl_LocalInvocationID.x == 0u) newCourses[p].pressure = swelling;
        p = piece.next;
    }
    return all;
}

// Polak and Ribiere's beta, since contact bends the way.
void leaveCourses(uint root, uint slot) {
    Answered all = answered(root, slot);
    if (gl_LocalInvocationID.x != 0u) return;
    bool begins = slot == kFirstSlot;
    for (uint p = root; p != kNoPiece;) {
        ImplicitPiece piece = pieceAt(p);
        vec4 before = knownOf(piece, slot - 1u);
        float scale = begins ? max(all.left, all.moved) : before.w;
        newCourses[p].beta = begins ? 0.0 : max(ratio(all.size - all.turned, before.y), 0.0);
        newCourses[p].size = all.size;
        newCourses[p].gamma = before.z;
        newCourses[p].scale = scale;
        bool done = !(all.size > kRounding * scale);
        bool close = done || all.size < implicit.bounds.close * scale;
        newCourses[p].done = done ? 1.0 : 0.0;
        newCourses[p].ended = close && slot >= numbers.y ? 1.0 : 0.0;
        p = piece.next;
    }
}
#include "sim/unfold/best_rotation.glsl"
STATE_TEXELS(kPositionsBinding) positions;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
STATE_TEXELS(kMemberSharesUnit) memberShares;
STATE_TEXELS(kTurnsUnit) turns;
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
#include "sim/implicit/coarse_rows.glsl"
#ifdef OF_REGIONS
#include "sim/implicit/levels.glsl"
#endif

const uint kSumGroups = 8u;
shared vec4 productRows[kSumGroups];
shared float lastRows[kSumGroups];

#ifdef OF_REGIONS
// Adds how its region moves the aggregate to ownModes.
void addRegion(uint aggregate) {
    uint region = regionOf(aggregate);
    uint first = motionOfRegion(region);
    for (uint row = gl_LocalInvocationID.x; row < kAggregateModes; row += GROUP) {
        uint m = row % 4u;
        vec3 motion = levelOf(aggregate, m).y * modeAt(first, m);
        if (m == 0u) {
            for (uint k = 1u; k < 4u; ++k) motion += levelOf(aggregate, k).x * modeAt(first, k);
        }
        vec3 moved = rotated(turnOfRegion(region), motion);
        ownModes[row] += turnedBack(turnOfAggregate(aggregate), moved)[row / 4u];
    }
    barrier();
}
#endif

// How an aggregate moves.
struct Motion {
    vec4 x, y, z;  // by the modes along an axis
    vec4 turn;
};

// AnswerSums of a vertex: the first texel, then the last of its sums.
struct Products {
    vec4 first;
    float last;
};

// Adds the motion of the aggregate to the answer of a member.
Products finish(uint member, Motion motion) {
    uint v = fetch(members, member).x;
    vec4 shares = vec4(1.0, fetch(memberShares, member).xyz);
    vec3 moved = rotated(motion.turn, vec3(dot(motion.x, shares), dot(motion.y, shares),
                                           dot(motion.z, shares)));
    bool held = !(fetch(positions, v).w > 0.0);
    vec3 answer = held ? vec3(0.0) : fetch(answers, v).xyz + moved;
    newAnswers[v] = vec4(answer, 0.0);
    mat2x3 left = leftAt(v);
    vec3 pressure = pressureAt(v);
    return Products(vec4(dot(left[0], answer), dot(fetch(gradients, v).xyz, answer),
                         dot(left[1], answer), dot(left[0], pressure)),
                    dot(left[1], pressure));
}

#ifdef LOAD_IMAGES  // groups of as many threads as rows of sums
void finishAll(uvec4 own, Motion motion) {
    Products sums = Products(vec4(0.0), 0.0);
    for (uint k = own.x + gl_LocalInvocationID.x; k < own.y; k += GROUP) {
        Products products = finish(k, motion);
        sums.first += products.first;
        sums.last += products.last;
    }
    productRows[gl_LocalInvocationID.x] = sums.first;
    lastRows[gl_LocalInvocationID.x] = sums.last;
}
#else
shared vec4 firsts[kMostMembers];
shared float lasts[kMostMembers];

void finishAll(uvec4 own, Motion motion) {
    uint count = own.y - own.x;
    for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
        Products products = finish(own.x + k, motion);
        firsts[k] = products.first;
        lasts[k] = products.last;
    }
    barrier();
    for (uint row = gl_LocalInvocationID.x; row < kSumGroups; row += GROUP) {
        vec4 sum = vec4(0.0);
        float last = 0.0;
        for (uint k = row; k < count; k += kSumGroups) {
            sum += firsts[k];
            last += lasts[k];
        }
        productRows[row] = sum;
        lastRows[row] = last;
    }
}
#endif

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    ImplicitPiece piece = pieceAt(own.z);
#ifndef OF_PRESSURE
    if (numbers.x != kFirstSlot && hasEnded(own.z)) return;
#endif
#ifdef OF_REGIONS
    findModes(uvec2(gl_WorkGroupID.x, 1u), own.w);
    addRegion(gl_WorkGroupID.x);
#else
    findModes(uvec2(piece.first_aggregate, piece.aggregate_count), own.w);
#endif
    vec4 turn = fetch(turns, implicit.patch_count + gl_WorkGroupID.x);
    finishAll(own, Motion(modesOf(0u), modesOf(1u), modesOf(2u), turn));
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
#ifndef OF_PRESSURE
    if (isLastGroup(piece)) leaveCourses(piece.root, numbers.x);
#endif
}
