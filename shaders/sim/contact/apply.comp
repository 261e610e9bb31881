// Adds to each vertex what its contacts sum up to: to d, which becomes velocity, and to X, which
// does not. Clears the sums for the next sweep, and in the LAST_SWEEP of a substep the shares. One
// thread per vertex. A storage barrier follows.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kContactSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kContactSumsBinding) buffer Sums { int sums[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "sim/fixed_sums.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
#ifdef LAST_SWEEP
    if (v == 0u) {
        state.last_contacts = state.contacts;
        state.contacts = 0u;
    }
#endif
    if (v >= uniforms.vertex_count || shares[v] == 0u) return;
#ifdef LAST_SWEEP
    shares[v] = 0u;
#endif
    displacement[v] = vec4(displacement[v].xyz + takeSum(6u * v), 0.0);
    positions[v] = vec4(positions[v].xyz + takeSum(6u * v + 3u), positions[v].w);
}
