// Solves each contact, of points and of edges, once: mass-splitting Jacobi, each vertex giving the share mass / (number of its
// contacts). Corrections are summed as integers, which do not mind the order in which threads come.
// Reads X (inverse mass), records, shares. Adds to sums. One thread per listed point. A storage
// barrier follows, then apply.
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kContactUniformsBinding) readonly buffer Uniforms { ContactUniforms uniforms; };
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactRecordsBinding) readonly buffer Records { ContactRecord records[]; };
layout(std430, binding = kContactSharesBinding) readonly buffer Shares { uint shares[]; };
layout(std430, binding = kContactSumsBinding) buffer Sums { int sums[]; };
layout(std430, binding = kContactStateBinding) readonly buffer State { ContactState state; };

#include "sim/fixed_sums.glsl"

void respond(ContactRecord record) {
    if (record.v1 == kNoVertex) return;
    uvec4 v = uvec4(record.v0, record.v1, record.v2, record.v3);
    vec4 w = uniforms.inverse_density *
        vec4(positions[v.x].w, positions[v.y].w, positions[v.z].w, positions[v.w].w);
    vec4 counts = vec4(shares[v.x], shares[v.y], shares[v.z], shares[v.w]);
    float weight = dot(counts * w, record.gains * record.gains);
    if (!(weight > 0.0)) return;
    vec3 impulse = record.impulse.xyz / weight;
    vec3 push = (record.normal.w / weight) * record.normal.xyz;
    for (int k = 0; k < 4; ++k) {
        float gain = record.gains[k] * w[k];
        if (gain != 0.0) addToSums(v[k], gain * impulse, gain * push);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    respond(records[index]);
    respond(records[state.points + index]);
}
