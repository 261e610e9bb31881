// Lifts vertices onto the floor, those that start below it at no more than lift_speed; Coulomb
// friction shortens their tangential displacement by at most friction * lift.
// Reads X. Reads and writes d. One thread per vertex. A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kDisplacementBinding) uniform samplerBuffer before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement { vec4 displacement[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 x = fetch(positions, v);
    vec3 d = fetch(before, v).xyz;
    float lowest = min(uniforms.floor_height - x.y, uniforms.lift_speed * uniforms.substep);
    float lift = lowest - d.y;
    if (!(lift > 0.0) || x.w == 0.0) return;
    d.y += lift;
    float slip = length(d.xz);
    if (slip > 0.0) {
        d.xz *= 1.0 - min(1.0, uniforms.friction * lift / slip);
    }
    displacement[v] = vec4(d, 0.0);
}
