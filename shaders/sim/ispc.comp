// Solves each internal shape-preserving constraint once against the displacement as it stands
// (XPBD, mass split among the ISPCs of a vertex): r = p_v - (b0 p_0 + b1 p_1 + b2 p_2), C = |r| - L0.
// Reads X, d, links, ISPCs. Writes the pull of each ISPC, which gather_corrections
// shares out. One thread per ISPC.
// A storage barrier follows, then gather_corrections.
#include "bindings.h"
#include "body_records.h"
#include "constraints.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kDisplacementBinding) uniform samplerBuffer displacement;
layout(binding = kLinksBinding) uniform usamplerBuffer links;
layout(binding = kConstraintsBinding) uniform usamplerBuffer ispcs;
layout(std430, binding = kCorrectionsBinding) writeonly buffer Corrections { vec4 corrections[]; };

#include "sim/pull_direction.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.ispc_count) return;
    IspcConstraint ispc = fetchIspc(ispcs, index);
    vec3 b = vec3(1.0 - ispc.b1 - ispc.b2, ispc.b1, ispc.b2);
    vec4 xv = fetch(positions, ispc.vertex);
    vec4 x0 = fetch(positions, ispc.t0);
    vec4 x1 = fetch(positions, ispc.t1);
    vec4 x2 = fetch(positions, ispc.t2);
    vec3 dv = fetch(displacement, ispc.vertex).xyz;
    vec3 d0 = fetch(displacement, ispc.t0).xyz;
    vec3 d1 = fetch(displacement, ispc.t1).xyz;
    vec3 d2 = fetch(displacement, ispc.t2).xyz;
    vec3 base = b.x * (xv.xyz - x0.xyz) + b.y * (xv.xyz - x1.xyz) + b.z * (xv.xyz - x2.xyz);
    vec3 step = b.x * (dv - d0) + b.y * (dv - d1) + b.z * (dv - d2);
    vec3 r = base + step;
    float reach = length(r);

    vec4 w = uniforms.inverse_density * vec4(xv.w, x0.w, x1.w, x2.w);
    vec4 counts = vec4(fetch(links, ispc.vertex).z, fetch(links, ispc.t0).z,
                       fetch(links, ispc.t1).z, fetch(links, ispc.t2).z);
    float weight = dot(counts * w, vec4(1.0, b * b));
    float gamma = uniforms.damping_ratio;
    float denominator = (1.0 + gamma) * weight + ispc.geometry * uniforms.ispc_compliance;
    vec3 direction = reach > 1e-12 ? pullDirection(base, r) : vec3(0.0);
    float impulse = weight > 0.0
        ? uniforms.ispc_share * -((reach - ispc.rest_length) + gamma * dot(direction, step)) /
            denominator
        : 0.0;
    corrections[index] = vec4(direction * impulse, 0.0);
}
