// Predicts the displacement of the substep, d = h (v + h g), and solves the edges against it: one
// mass-splitting Jacobi sweep of XPBD, damped in proportion to stiffness (gamma = beta / h).
// Reads X, velocities, links, edges and their incidence. Writes d.
// One thread per vertex: it works each incident edge out anew, in the fixed order of the incidence,
// and predicts its neighbours from their velocities, so that no second buffer is needed.
// With SWEEP_AGAIN it starts from a copy of d instead: the later sweeps of plain PBD.
// A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "constraints.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kVelocitiesBinding) uniform samplerBuffer velocities;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement { vec4 displacement[]; };
layout(binding = kLinksBinding) uniform usamplerBuffer links;
layout(binding = kConstraintsBinding) uniform usamplerBuffer edges;
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer entries;

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

// What the edge adds to the displacement of v, which has `ownCount` of them.
vec3 correction(EdgeConstraint edge, uint v, vec4 own, float ownCount, vec3 ownStart) {
    uint other = edge.a == v ? edge.b : edge.a;
    vec4 far = fetch(positions, other);
    vec3 step = ownStart - startOf(other, far.w);
    vec3 span = (own.xyz - far.xyz) + step;
    float reach = length(span);
    if (reach < 1e-12) {
        return vec3(0.0);
    }
    float farCount = float(fetch(links, other).x);
    float inverseMasses = uniforms.inverse_density * (ownCount * own.w + farCount * far.w);
    float gamma = uniforms.damping_ratio;
    float denominator =
        (1.0 + gamma) * inverseMasses + edge.geometry * uniforms.stretch_compliance;
    if (!(denominator > 0.0)) {
        return vec3(0.0);
    }
    vec3 direction = span / reach;
    float impulse = -((reach - edge.rest_length) + gamma * dot(direction, step)) / denominator;
    return direction * (uniforms.stretch_share * uniforms.inverse_density * own.w * impulse);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 own = fetch(positions, v);
    vec3 start = startOf(v, own.w);
    vec3 sum = vec3(0.0);
    if ((uniforms.active_parts & kStretchPart) != 0u && own.w > 0.0) {
        float count = float(fetch(links, v).x);
        uvec2 range = fetch(ranges, v).xy;
        for (uint k = range.x; k < range.y; ++k) {
            EdgeConstraint edge = fetchEdge(edges, fetch(entries, k).x >> 2);
            sum += correction(edge, v, own, count, start);
        }
    }
    displacement[v] = vec4(start + sum, 0.0);
}
