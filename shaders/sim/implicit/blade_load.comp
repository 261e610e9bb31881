// Adds up what the body of the blade has done to each vertex and the triangles at it in a stage:
// its forces and their moment about the middle of the blade's box, times square of the step.
// Numbers: the substep, the share of the step that the stage counts for, as bits. One thread per
// vertex. A storage barrier follows.
#include "sim/base/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
#include "blade_records.h"
layout(local_size_x = kGroupSize) in;
#include "sim/implicit/contact_rows.glsl"
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kRowStatesUnit) states;
RECORD_QUADS(kRowVerticesUnit) rowVertices;
layout(std430, binding = kLoadBladesBinding) readonly buffer Blades { BladeRecord blades[]; };
layout(std430, binding = kMadeLoadsBinding) buffer Loads { VertexLoad loads[]; };

float share = uintBitsToFloat(numbers.y) * implicit.step * implicit.step;
vec3 middle = blades[numbers.x].box.center.xyz;

// What a row gives to the body.
VertexLoad loadOf(uint row) {
    ContactRow contact = rowAt(row);
    VertexLoad none = VertexLoad(vec4(0.0), vec4(0.0));
    if (!(contact.slip.w > 0.0) || contact.weights.x != kOfBlade) return none;
    vec3 slip = fetch(states, 2u * row).xyz;
    vec4 push = fetch(states, 2u * row + 1u);
    float grip = push.x > 0.0 ? gripOf(contact.slip.w, slip, push.x) : 0.0;
    vec3 force = share * (push.y * contact.normal.xyz - grip * slip);
    uvec4 v = fetch(rowVertices, row);
    vec3 x = firstWeight(contact.weights) * fetch(positions, v.x).xyz +
        contact.weights.y * fetch(positions, v.y).xyz +
        contact.weights.z * fetch(positions, v.z).xyz;
    return VertexLoad(vec4(force, 0.0), vec4(cross(x - middle, force), 0.0));
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    VertexLoad face = loadOf(kRowsOfVertex * v + kMeetsObstacle);
    VertexLoad corner = loadOf(kRowsOfVertex * v + kMeetsCorner);
    loads[v].given += face.given + corner.given;
    loads[v].moment += face.moment + corner.moment;
}
