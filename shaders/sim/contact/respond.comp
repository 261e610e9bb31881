// Solves each contact, of points and of edges, once: mass-splitting Jacobi, see mass_shares.glsl.
// Corrections are summed as integers, which do not mind the order in which threads come.
// With SWEEP_AGAIN it goes on from d as it stands: impulses add up over the sweeps, and what
// earlier ones did too much is taken back. A contact that stops a part of the approach alone leaves
// a speed that the body does not move with, since pushes take the way back.
// Reads X (inverse mass), d, records, shares. Adds to sums, with SWEEP_AGAIN to the impulses of the
// records. One thread per listed point. A storage barrier follows, then apply.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactDisplacementBinding) readonly buffer Displacement {
    vec4 displacement[];
};
layout(std430, binding = kContactRecordsBinding) buffer Records { ContactRecord records[]; };
layout(std430, binding = kContactSharesBinding) readonly buffer Shares { uint shares[]; };
layout(std430, binding = kContactSumsBinding) buffer Sums { int sums[]; };
layout(std430, binding = kContactStateBinding) readonly buffer State { ContactState state; };

#include "sim/contact_answer.glsl"
#include "sim/fixed_sums.glsl"
#include "sim/mass_shares.glsl"

// Of d and of X, in all [m].
struct Change {
    vec3 impulse;
    vec3 push;
};

#ifdef SWEEP_AGAIN
Change changeBy(uint place, ContactRecord record, uvec4 v, float friction) {
    vec3 slip = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        slip += record.gains[k] * displacement[v[k]].xyz;
    }
    vec3 sum = goOn(record.impulse.xyz, record.normal.xyz, slip, record.impulse.w, friction);
    records[place].impulse.xyz = sum;
    return Change(sum - record.impulse.xyz, vec3(0.0));
}
#else
Change changeBy(uint place, ContactRecord record, uvec4 v, float friction) {
    return Change(record.impulse.xyz, record.normal.w * record.normal.xyz);
}
#endif

void respond(uint place, float friction) {
    ContactRecord record = records[place];
    if (record.v1 == kNoVertex) return;
    uvec4 v = uvec4(record.v0, record.v1, record.v2, record.v3);
    vec4 w = uniforms.inverse_density *
        vec4(positions[v.x].w, positions[v.y].w, positions[v.z].w, positions[v.w].w);
    float weight = 0.0;
    for (int k = 0; k < 4; ++k) {
        weight += w[k] * sharedWeight(record.gains[k], shares[v[k]]);
    }
    if (!(weight > 0.0)) return;
    Change change = changeBy(place, record, v, friction);
    for (int k = 0; k < 4; ++k) {
        float gain = record.gains[k] * w[k] / weight;
        if (gain != 0.0) addToSums(v[k], gain * change.impulse, gain * change.push);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    respond(index, uniforms.friction);
    respond(state.points + index, 0.0);  // see detect_edges
}
