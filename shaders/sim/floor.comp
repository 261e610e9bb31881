// Lifts vertices onto the floor, those that start below it at no more than lift_speed; Coulomb
// friction shortens their tangential displacement by at most friction * lift.
// Reads X. Reads and writes d. One thread per vertex. A storage barrier follows.
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};

#include "sim/floor.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    displacement[v] = vec4(onFloor(fetch(before, v).xyz, fetch(positions, v)), 0.0);
}
