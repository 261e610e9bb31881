#pragma once
// Constraints pull along their gradient at X, the beginning of the substep, as SHAKE does: then no
// sweep changes the angular momentum sum X x m d, which the velocities d / h carry on. Where the
// gradient has turned too far meanwhile, as at slivers, the one at X + d is taken, and always in
// plain PBD, which sweeps many times over a long step. There constraints are rigid and not damped;
// kernels with PLAIN_PBD are compiled for it alone and leave out what it does not need. The
// includer declares `uniforms`.
#include "unfold_records.h"

// In the substep it turned by no more than 60 degrees and kept half of its size.
bool turnedLittle(vec3 before, vec3 now) {
    return dot(before, now) > 0.5 * max(dot(before, before), dot(now, now));
}

#ifdef PLAIN_PBD
bool pullsAsBefore() {
    return false;
}

float dampingOf(float weight, float compliance, float fold, uint type) {
    return 0.0;
}

float dampedError(float error, float rate, float gamma, float fold, float perWay) {
    return error;
}

float dampedWeight(float weight, float compliance, float gamma, uint type) {
    return weight;
}
#else
bool pullsAsBefore() {
    return (uniforms.active_parts & kPullAsBeforePart) != 0u;
}

// Gamma of a constraint on skin that is so far folded (folds.glsl).
float dampingAt(float fold) {
    return uniforms.damping_ratio * (1.0 - fold);
}

bool hasTrueModulus() {
    return (uniforms.active_parts & kTrueModulusPart) != 0u;
}

// The same of one that a sweep moves with this weight. With a true modulus stiffness comes first:
// damping gets what the room of its type leaves it.
float dampingOf(float weight, float compliance, float fold, uint type) {
    float gamma = dampingAt(fold);
    float room = 2.0 * compliance / max(uniforms.sweep_room[type] * weight, 1e-30) - 1.5;
    return hasTrueModulus() ? clamp(room, 0.0, gamma) : gamma;
}

// What an impulse is to answer to: C, and its rate times gamma. Where the skin is folded what C was
// at X goes back at catch_up_speed at most, in the way of a vertex of which each metre changes C by
// `perWay`.
float dampedError(float error, float rate, float gamma, float fold, float perWay) {
    float damped = error + gamma * rate;
#ifdef UNFOLDS
    float most = uniforms.catch_up_speed * uniforms.substep * perWay / max(fold, 1e-6);
    float bounded = clamp(error - rate, -most, most) + (1.0 + gamma) * rate;
    return fold > 0.0 ? bounded : damped;
#else
    return damped;
#endif
}

// What an impulse is divided by.
float dampedWeight(float weight, float compliance, float gamma, uint type) {
    float least = uniforms.sweep_room[type] * (0.75 + 0.5 * gamma) * weight;
    return hasTrueModulus() ? max(compliance, least) : (1.0 + gamma) * weight + compliance;
}
#endif

vec3 pullDirection(vec3 before, vec3 now) {
    bool asBefore = pullsAsBefore() && turnedLittle(before, now);
    return (asBefore ? before : now) * inversesqrt(asBefore ? dot(before, before) : dot(now, now));
}
