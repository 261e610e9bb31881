// Ends a step on the floor: v = d / h exp(-c h), X += d. Vertices without inverse mass keep their
// velocity. Reads d, which stays as it was. Reads and writes X and velocities. One thread per
// vertex. A storage barrier follows.
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) before;
layout(std430, binding = kPositionsBinding) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
STATE_TEXELS(kDisplacementBinding) displacement;

#include "sim/floor.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 x = fetch(before, v);
    vec3 d = fetch(displacement, v).xyz;
    if ((uniforms.active_parts & kFloorPart) != 0u) d = onFloor(d, x);
    if (x.w > 0.0) {
        velocities[v] = vec4(d / uniforms.substep * uniforms.drag_factor, 0.0);
    }
    positions[v] = vec4(x.xyz + d, x.w);
}
