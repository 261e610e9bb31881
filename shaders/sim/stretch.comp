// Predicts the displacement of the substep, d = h (v + h g), and solves the edges against it: one
// mass-splitting Jacobi sweep of XPBD, damped in proportion to stiffness (gamma = beta / h).
// Reads X, velocities and the spokes of each vertex. Writes d.
// One thread per vertex: it works each incident edge out anew, in the fixed order of the incidence,
// and predicts its neighbours from their velocities, so that no second buffer is needed.
// With SWEEP_AGAIN it starts from a copy of d instead: the later sweeps of plain PBD.
// A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kVelocitiesBinding) uniform samplerBuffer velocities;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement { vec4 displacement[]; };
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer spokes;

#include "sim/pull_direction.glsl"

#ifdef SWEEP_AGAIN
layout(binding = kPreviousBinding) uniform samplerBuffer previous;

vec3 startOf(uint v, float inverseMass) {
    return fetch(previous, v).xyz;
}
#else
vec3 startOf(uint v, float inverseMass) {
    vec3 speed = fetch(velocities, v).xyz;
    if (inverseMass > 0.0) {
        speed += uniforms.substep * uniforms.gravity.xyz;
    }
    return uniforms.substep * speed;
}
#endif

// What a spoke adds to the displacement of its vertex, which has `count` of them.
vec3 correction(Spoke spoke, vec4 own, float count, vec3 ownStart) {
    vec4 far = fetch(positions, spoke.other);
    vec3 step = ownStart - startOf(spoke.other, far.w);
    vec3 before = own.xyz - far.xyz;
    vec3 span = before + step;
    float reach = length(span);
    if (reach < 1e-12) {
        return vec3(0.0);
    }
    float inverseMasses =
        uniforms.inverse_density * (count * own.w + float(spoke.other_count) * far.w);
    float gamma = uniforms.damping_ratio;
    float denominator =
        (1.0 + gamma) * inverseMasses + spoke.geometry * uniforms.stretch_compliance;
    if (!(denominator > 0.0)) {
        return vec3(0.0);
    }
    vec3 direction = pullDirection(before, span);
    float impulse = -((reach - spoke.rest_length) + gamma * dot(direction, step)) / denominator;
    return direction * (uniforms.stretch_share * uniforms.inverse_density * own.w * impulse);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 own = fetch(positions, v);
    vec3 start = startOf(v, own.w);
    vec3 sum = vec3(0.0);
    if ((uniforms.active_parts & kStretchPart) != 0u && own.w > 0.0) {
        uvec2 range = fetch(ranges, v).xy;
        for (uint k = range.x; k < range.y; ++k) {
            sum += correction(fetchSpoke(spokes, k), own, float(range.y - range.x), start);
        }
    }
    displacement[v] = vec4(start + sum, 0.0);
}
