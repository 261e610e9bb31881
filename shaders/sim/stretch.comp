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

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) readonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kConstraintsBinding) readonly buffer Edges { EdgeConstraint edges[]; };
layout(std430, binding = kRangesBinding) readonly buffer Ranges { IncidenceRange ranges[]; };
layout(std430, binding = kEntriesBinding) readonly buffer Entries { uint entries[]; };

#ifdef SWEEP_AGAIN
layout(std430, binding = kPreviousBinding) readonly buffer Previous { vec4 previous[]; };

vec3 startOf(uint v, float inverseMass) {
    return previous[v].xyz;
}
#else
vec3 startOf(uint v, float inverseMass) {
    vec3 speed = velocities[v].xyz;
    if (inverseMass > 0.0) {
        speed += uniforms.substep * uniforms.gravity.xyz;
    }
    return uniforms.substep * speed;
}
#endif

// What the edge adds to the displacement of v.
vec3 correction(EdgeConstraint edge, uint v, vec4 own, vec3 ownStart) {
    uint other = edge.a == v ? edge.b : edge.a;
    vec4 far = positions[other];
    vec3 step = ownStart - startOf(other, far.w);
    vec3 span = (own.xyz - far.xyz) + step;
    float reach = length(span);
    if (reach < 1e-12) {
        return vec3(0.0);
    }
    float inverseMasses =
        uniforms.inverse_density * (float(links[v].edges) * own.w + float(links[other].edges) * far.w);
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
    vec4 own = positions[v];
    vec3 start = startOf(v, own.w);
    vec3 sum = vec3(0.0);
    if ((uniforms.active_parts & kStretchPart) != 0u && own.w > 0.0) {
        for (uint k = ranges[v].first; k < ranges[v].end; ++k) {
            sum += correction(edges[entries[k] >> 2], v, own, start);
        }
    }
    displacement[v] = vec4(start + sum, 0.0);
}
