// For each vertex at a fold: how it and its neighbours lie at rest, put where that fits best to
// where they are (shape matching, Mueller et al. 2005), and the rigid motion that has their
// momentum. A vertex lends its mass to the goals that it is in, in proportion to their folds; then
// what they do to it changes no momentum. Where one of them has no inverse mass, as at the front of
// a slit, the goal draws nothing. The includer declares `uniforms`, `restPositions`, `neighbours`,
// positionOf(v), velocityOf(v), foldSumOf(v).
#include "best_rotation.glsl"
#include "damping.glsl"
#include "members.glsl"
#include "sim/unfold/spin.glsl"

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
