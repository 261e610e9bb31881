// The goals of folded vertices . Reads X, velocities, rest positions, folds,
// neighbours. Writes goals. One thread per vertex: the few that have a fold add the folds of their
// members up themselves. A storage barrier follows, then unfold.
#include "unfold_records.h"
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) neighbours;
STATE_TEXELS(kUnfoldRestBinding) restPositions;
RECORD_WORDS(kUnfoldFoldsBinding) folds;
layout(std430, binding = kUnfoldGoalsBinding) writeonly buffer Goals { UnfoldGoal goals[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 velocityOf(uint v) { return fetch(velocities, v); }
float foldAt(uint v) { return uintBitsToFloat(fetch(folds, v).x); }

#include "members.glsl"
#include "sim/unfold/spin.glsl"

// For each vertex at a fold: how it and its neighbours lie at rest, put where that fits best to
// where they are (shape matching, Mueller et al. 2005), and the rigid motion that has their
// momentum. A vertex lends its mass to the goals that it is in, in proportion to their folds; then
// what they do to it changes no momentum. Where one of them has no inverse mass, as at the front of
// a slit, the goal draws nothing.
struct Member {
    float mass;  // that it lends, over the fold of the goal
    vec3 x, rest, velocity;
};

Member memberAt(uint v) {
    vec4 x = positionOf(v);
    float sum = foldSumOf(v);
    return Member(x.w > 0.0 ? 1.0 / (x.w * sum) : 0.0, x.xyz, fetch(restPositions, v).xyz,
                  velocityOf(v).xyz);
}

// Relative to another, so that floats keep their digits.
Member memberFrom(Member origin, uint v) {
    Member m = memberAt(v);
    return Member(m.mass, m.x - origin.x, m.rest - origin.rest, m.velocity - origin.velocity);
}

struct Mean {
    float perMass;  // one over the mass of all
    vec3 x, rest, velocity;
};

Mean meanOf(uint v, uvec2 range, uint count, Member origin) {
    float mass = 0.0;
    vec3 x = vec3(0.0);
    vec3 rest = vec3(0.0);
    vec3 velocity = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        Member m = memberFrom(origin, memberOf(v, range, i));
        mass += m.mass;
        x += m.mass * m.x;
        rest += m.mass * m.rest;
        velocity += m.mass * m.velocity;
    }
    float perMass = mass > 0.0 ? 1.0 / mass : 0.0;
    return Mean(perMass, perMass * x, perMass * rest, perMass * velocity);
}

UnfoldGoal goalOf(uint v, uvec2 range) {
    uint count = memberCount(range);
    Member origin = memberAt(v);
    Mean mean = meanOf(v, range, count, origin);
    vec3 sx = vec3(0.0);
    vec3 sy = vec3(0.0);
    vec3 sz = vec3(0.0);
    vec3 angularMomentum = vec3(0.0);
    vec3 squares = vec3(0.0);
    vec3 mixed = vec3(0.0);
    for (uint i = 0u; i < count; ++i) {
        Member m = memberFrom(origin, memberOf(v, range, i));
        vec3 rest = m.rest - mean.rest;
        vec3 x = m.x - mean.x;
        vec3 weighted = (m.mass * mean.perMass) * x;
        sx += rest.x * weighted;
        sy += rest.y * weighted;
        sz += rest.z * weighted;
        angularMomentum += cross(weighted, m.velocity - mean.velocity);
        squares += weighted * x;
        mixed += weighted.yzx * x.zxy;
    }
    vec4 spin = spinOf(angularMomentum, squares, mixed);
    vec4 rotation = bestRotation(sx, sy, sz);
    // What the spring knows of the way: what it covers at that speed in its time.
    float reach = uniforms.catch_up_speed * unfoldDamping() / kUnfoldRate;
    float longest = reach;
    bool free = true;
    for (uint i = 0u; i < count; ++i) {
        Member m = memberFrom(origin, memberOf(v, range, i));
        float way = length(mean.x + rotated(rotation, m.rest - mean.rest) - m.x);
        longest = max(longest, way);
        free = free && m.mass > 0.0;
    }
    return UnfoldGoal(rotation, vec4(origin.x + mean.x, free ? spin.w : 0.0),
                      vec4(origin.rest + mean.rest, free ? reach / longest : 0.0),
                      vec4(origin.velocity + mean.velocity, 0.0), vec4(spin.xyz, 0.0));
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uvec2 range = fetch(ranges, v).xy;
    for (uint once = fetch(folds, v).x != 0u ? 1u : 0u; once > 0u; --once) {
        goals[v] = goalOf(v, range);
    }
}
