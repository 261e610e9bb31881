// Pulls the vertices that hands hold: to each a critically damped spring, worked out for the end of
// the step, so that no rate is too stiff. Independent of its mass: a = -r^2 (p - target) - 2 r
// (v - motion). A force has its share of the way in each sweep.
// Reads X, pulls. Reads and writes d. One thread per pull; no two name one vertex.
// A storage barrier follows.
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kPullsBinding) readonly buffer Pulls { PullRecord pulls[]; };

vec3 forceWay(PullRecord pull) {
    return uniforms.substep * uniforms.substep / float(uniforms.sweeps) *
           vec3(pull.motion_x, pull.motion_y, pull.motion_z);
}

vec3 pulled(vec3 d, vec4 x, PullRecord pull) {
    vec3 away = (x.xyz - vec3(pull.target_x, pull.target_y, pull.target_z)) + d;
    vec3 slip = d - uniforms.substep * vec3(pull.motion_x, pull.motion_y, pull.motion_z);
    float r = kPullRate * uniforms.substep;
    vec3 change = (r * r * away + 2.0 * r * slip) / (1.0 + 2.0 * r + r * r);
    if (pull.leads == kForcePull) change = -forceWay(pull);
    return x.w > 0.0 ? d - (pull.leads == 1u ? slip : change) : d;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.pull_count) return;
    PullRecord pull = pulls[index];
    vec3 d = displacement[pull.vertex].xyz;
    displacement[pull.vertex] = vec4(pulled(d, positions[pull.vertex], pull), 0.0);
}
