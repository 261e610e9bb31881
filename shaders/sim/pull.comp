// Pulls the vertices that hands hold: to each a critically damped spring, worked out for the end of
// the substep, so that no rate is too stiff. Independent of its mass: a = -r^2 (p - target) - 2 r
// (v - motion).
// Reads X, pulls. Reads and writes d. One thread per pull; no two name one vertex.
// A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kPullsBinding) readonly buffer Pulls { PullRecord pulls[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.pull_count) return;
    PullRecord pull = pulls[index];
    vec4 x = positions[pull.vertex];
    if (!(x.w > 0.0)) return;
    vec3 d = displacement[pull.vertex].xyz;
    vec3 away = (x.xyz - vec3(pull.target_x, pull.target_y, pull.target_z)) + d;
    vec3 slip = d - uniforms.substep * vec3(pull.motion_x, pull.motion_y, pull.motion_z);
    float r = kPullRate * uniforms.substep;
    displacement[pull.vertex] =
        vec4(d - (r * r * away + 2.0 * r * slip) / (1.0 + 2.0 * r + r * r), 0.0);
}
