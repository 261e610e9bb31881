// Goes along the direction, and begins the preconditioner's answer to the residual that is left:
// patch by patch, and the residual by the modes of each aggregate, which coarse.comp goes on with.
//   way += alpha p,  r -= alpha image + pressure dV/dp
// With OF_START it goes from where the stage begins, with OF_PRESSURE it only answers to dV/dp.
// Numbers: the slot. One group for each aggregate. A storage barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/pieces.glsl"
#include "sim/unfold/best_rotation.glsl"
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kGradientsBinding) gradients;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
STATE_TEXELS(kMemberSharesUnit) memberShares;
STATE_TEXELS(kPatchInverseUnit) patchInverse;
STATE_TEXELS(kTurnsUnit) turns;
layout(std430, binding = kAnswerBinding) writeonly buffer Answers { vec4 newAnswers[]; };
layout(std430, binding = kModesBinding) writeonly buffer Modes { vec4 modes[]; };

const uint kModeRows = 8u;
shared vec4 modeRows[kModeRows * 3u];

// The residual of each member as its patch has turned, for all threads of the group.
#ifdef LOAD_IMAGES  // shared memory is read lane by lane there
layout(std430, binding = kTurnedBinding) coherent writeonly buffer Turned { vec4 turned[]; };
layout(binding = kTurnedUnit, rgba32f) coherent readonly uniform imageBuffer turnedTexels;
vec3 turnedAt(uint member, uint first) { return imageLoad(turnedTexels, int(member)).xyz; }
void setTurned(uint member, uint first, vec3 r) { turned[member] = vec4(r, 0.0); }
#else
shared vec4 turned[kMostMembers];
vec3 turnedAt(uint member, uint first) { return turned[member - first].xyz; }
void setTurned(uint member, uint first, vec3 r) { turned[member - first] = vec4(r, 0.0); }
#endif

#if defined(OF_START) || defined(OF_PRESSURE)
bool hasEnded(uint piece) { return false; }
#else
STATE_TEXELS(kCoursesUnit) courses;
bool hasEnded(uint piece) { return fetch(courses, kCourseTexels * piece + 1u).z != 0.0; }
#endif
#ifdef OF_PRESSURE
layout(std430, binding = kPiecesBinding) readonly buffer Records { PieceRecord records[]; };
bool holdsVolume = false;
void prepare(uint piece) {
    holdsVolume = implicit.holds_volume != 0u && records[piece].constrained != 0u;
}
vec3 residualOf(uint v) { return holdsVolume ? fetch(gradients, v).xyz : vec3(0.0); }
#else
#include "sim/implicit/advance.glsl"
#endif

vec4 inverseOf(vec4 turn) { return vec4(-turn.xyz, turn.w); }

ImplicitMember memberAt(uint k) {
    uvec4 words = fetch(members, k);
    return ImplicitMember(words.x, words.y, words.z, words.w);
}

vec3 answerOf(ImplicitMember member, uint first) {
    uint begin = member.neighbours & 0xffffffu;
    uint count = member.neighbours >> 24;
    vec3 sum = vec3(0.0);
    for (uint j = 0u; j < count; ++j) {
        uint at = 3u * (member.inverse + j);
        vec3 r = turnedAt(begin + j, first);
        sum += vec3(dot(fetch(patchInverse, at).xyz, r), dot(fetch(patchInverse, at + 1u).xyz, r),
                    dot(fetch(patchInverse, at + 2u).xyz, r));
    }
    return rotated(fetch(turns, member.patch_number), sum);
}

// What the members with one remainder of their number have of the modes: of each axis four.
void sumModes(uint row, uint first, uint count, vec4 turn) {
    vec4 x = vec4(0.0);
    vec4 y = vec4(0.0);
    vec4 z = vec4(0.0);
    for (uint k = row; k < count; k += kModeRows) {
        vec4 shares = vec4(1.0, fetch(memberShares, first + k).xyz);
        vec4 ofPatch = fetch(turns, fetch(members, first + k).y);
        vec3 r = rotated(inverseOf(turn), rotated(ofPatch, turnedAt(first + k, first)));
        x += r.x * shares;
        y += r.y * shares;
        z += r.z * shares;
    }
    modeRows[3u * row] = x;
    modeRows[3u * row + 1u] = y;
    modeRows[3u * row + 2u] = z;
}

void main() {
    uvec4 words = fetch(aggregates, gl_WorkGroupID.x);
    ImplicitAggregate own = ImplicitAggregate(words.x, words.y, words.z, words.w);
    uint count = own.end - own.first;
    if (hasEnded(own.piece)) return;
    prepare(own.piece);
    for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
        ImplicitMember member = memberAt(own.first + k);
        bool held = !(fetch(positions, member.vertex).w > 0.0);
        vec3 residual = residualOf(member.vertex);
        if (held) residual = vec3(0.0);
        setTurned(own.first + k, own.first,
                  rotated(inverseOf(fetch(turns, member.patch_number)), residual));
    }
    memoryBarrier();
    barrier();
    for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
        ImplicitMember member = memberAt(own.first + k);
        newAnswers[member.vertex] = vec4(answerOf(member, own.first), 0.0);
    }
    vec4 turn = fetch(turns, implicit.patch_count + gl_WorkGroupID.x);
    for (uint row = gl_LocalInvocationID.x; row < kModeRows; row += GROUP) {
        sumModes(row, own.first, count, turn);
    }
    barrier();
    for (uint axis = gl_LocalInvocationID.x; axis < 3u; axis += GROUP) {
        vec4 sum = vec4(0.0);
        for (uint row = 0u; row < kModeRows; ++row) sum += modeRows[3u * row + axis];
        modes[3u * gl_WorkGroupID.x + axis] = sum;
    }
}
