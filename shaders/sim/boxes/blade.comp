// Keeps vertices out of the body of the blade, whose own way in the substep counts: d ends at the
// face that the way from X to X + d enters through. What starts inside sinks no deeper, and X is
// pushed out, slowly. Coulomb friction shortens the way of skin along the face; walls have none: a
// cut is wet, and dragged along they would crumple.
//
// Reads triangles around each vertex, X before any was pushed (other threads push the vertices
// around), the blade. Reads and writes X and d. One thread per vertex. A storage barrier follows.
#include "blade_records.h"
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kBoxTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kBoxBoxesBinding) readonly buffer Blades { BladeRecord blades[]; };
layout(std430, binding = kBladeRangesBinding) readonly buffer Ranges { IncidenceRange ranges[]; };
layout(std430, binding = kBladeIncidenceBinding) readonly buffer Incidence { uint incidence[]; };
layout(std430, binding = kBladeAroundBinding) readonly buffer Around { vec4 around[]; };

#include "sim/base/numbers.glsl"

uvec4 triangleAt(uint t) { return triangles[t]; }
IncidenceRange rangeAt(uint v) { return ranges[v]; }
uint incidentAt(uint k) { return incidence[k]; }
vec3 aroundAt(uint v) { return around[v].xyz; }
#include "blade_faces.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= obstacle.vertex_count || positions[v].w == 0.0) return;
    BladeRecord blade = blades[numbers.x];
    vec3 x = positions[v].xyz;
    vec3 at = toBox(blade.box, x - blade.box.center.xyz);
    vec3 way = toBox(blade.box, displacement[v].xyz - wayOfBlade(blade, x));
    bool near = mayMeet(blade, at, at + way);
    vec4 wall = wallNormal(v, near);
    if (!near) return;
    wall.xyz = toBox(blade.box, wall.xyz);
    Faces faces = facesFor(wall, at, blade.turn.w);
    vec3 before = gapsAt(blade, at, faces.side);
    vec3 after = gapsAt(blade, at + way, faces.side);
    int face = faceFor(faces, before, after, 2.1 * blade.turn.w);
    if (face == 3) return;
    float lift = max(min(before[face], 0.0) - after[face], 0.0);
    float friction = wall.w == 0.0 ? obstacle.friction : 0.0;
    vec3 along = way;
    along[face] = 0.0;
    vec3 change = along * (slipLeft(length(along), lift, friction) - 1.0);
    change[face] = faces.side[face] * lift;
    displacement[v] = vec4(displacement[v].xyz + fromBox(blade.box, change), 0.0);
    vec3 push = vec3(0.0);
    push[face] = faces.side[face] * clamp(-(after[face] + lift), 0.0, obstacle.push);
    positions[v] = vec4(x + fromBox(blade.box, push), positions[v].w);
}
