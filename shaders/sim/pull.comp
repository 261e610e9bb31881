// Pulls the vertices that hands hold: to each a critically damped spring, worked out for the end of
// the substep, so that no rate is too stiff. Independent of its mass: a = -r^2 (p - target) - 2 r
// (v - motion).
// Reads X, pulls. Reads and writes d. One thread per pull; no two name one vertex.
// A storage barrier follows.
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kPullsBinding) readonly buffer Pulls { PullRecord pulls[]; };

vec4 positionOf(uint v) { return positions[v]; }
vec4 displacementOf(uint v) { return displacement[v]; }
void setDisplacement(uint v, vec4 d) { displacement[v] = d; }
#include "sim/pull.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.pull_count) return;
    pullBy(pulls[index]);
}
