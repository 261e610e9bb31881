// Adds up what contact with the body of the blade has changed of each vertex in the substep: mass
// times change of d, and the moment of that about the middle of the blade's box.
// Reads X (inverse mass), d, d before the contact, the blade. Adds to loads. One thread per vertex.
#include "blade_records.h"
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxDisplacementBinding) readonly buffer Displacement {
    vec4 displacement[];
};
layout(std430, binding = kBoxBoxesBinding) readonly buffer Blades { BladeRecord blades[]; };
layout(std430, binding = kBladeBeforeBinding) readonly buffer Before { vec4 before[]; };
layout(std430, binding = kBladeLoadsBinding) buffer Loads { VertexLoad loads[]; };

#include "blade.glsl"
#include "sim/base/numbers.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= obstacle.vertex_count || positions[v].w == 0.0) return;
    float mass = 1.0 / (obstacle.inverse_density * positions[v].w);
    vec3 given = mass * (displacement[v].xyz - before[v].xyz);
    vec3 arm = positions[v].xyz - blades[numbers.x].box.center.xyz;
    loads[v].given += vec4(given, 0.0);
    loads[v].moment += vec4(cross(arm, given), 0.0);
}
