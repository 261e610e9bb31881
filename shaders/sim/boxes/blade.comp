// Keeps vertices out of the body of the blade, whose own way in the substep counts: d ends at the
// face that the way from X to X + d enters through. What starts inside sinks no deeper, and X is
// pushed out, slowly. Coulomb friction shortens the way of skin along the face; walls have none: a
// cut is wet, and dragged along they would crumple.
//
// The walls of the slit that the edge has just cut start in the middle of the plate: their outward
// normals say to which of the flat sides they belong. Where walls of both sides meet, as at the
// front and at the end of a slit, nothing is pushed. Skin belongs to the side that it is on.
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

#include "blade.glsl"
#include "boxes.glsl"

// A mean normal of walls is this long along a face that the walls are to answer to.
const float kFacing = 0.3;
// It is this long where it overrules that the walls lie on the other side, by more than half of the
// way to the face.
const float kClearlyFacing = 0.7;

float halfAt(BladeRecord blade, float y) {
    return blade.turn.w * clamp((y - blade.shift.w) / blade.bevel.x, 0.0, 1.0);
}

// How far p is outside of the end, the back and the flat side of `side`.
vec3 gapsAt(BladeRecord blade, vec3 p, vec3 side) {
    return vec3(side.x * p.x, p.y, side.z * p.z) -
        vec3(blade.box.x.w, blade.box.y.w, halfAt(blade, p.y));
}

bool mayMeet(BladeRecord blade, vec3 from, vec3 to) {
    vec3 low = min(from, to);
    vec3 high = max(from, to);
    vec3 reach = vec3(blade.box.x.w, blade.box.y.w, blade.turn.w);
    return all(lessThan(low, reach)) && high.x > -reach.x && high.z > -reach.z &&
        to.y > blade.shift.w;
}

// xyz: the sum of the area vectors of the walls at v over the sum of their lengths, w: 1 where
// there are any.
vec4 wallNormal(uint v, bool wanted) {
    IncidenceRange range = ranges[v];
    uint end = wanted ? range.end : range.first;
    vec3 sum = vec3(0.0);
    float size = 0.0;
    for (uint k = range.first; k < end; ++k) {
        uvec4 t = triangles[incidence[k] / 4u];
        if ((t.w & 1u) == 0u) continue;
        vec3 a = around[t.x].xyz;
        vec3 area = cross(around[t.y].xyz - a, around[t.z].xyz - a);
        sum += area;
        size += length(area);
    }
    return size > 0.0 ? vec4(sum / size, 1.0) : vec4(0.0);
}

// To which faces a vertex answers, and on which side of the blade it is.
struct Faces {
    bvec3 open;
    vec3 side;
};

Faces facesFor(vec4 wall, vec3 at, float halfThickness) {
    Faces faces = Faces(bvec3(true), vec3(at.x < 0.0 ? -1.0 : 1.0, 1.0, at.z < 0.0 ? -1.0 : 1.0));
    if (wall.w == 0.0) return faces;
    bvec3 facing = lessThan(faces.side * wall.xyz, vec3(-kFacing));
    facing.z = abs(wall.z) > kFacing;
    if (abs(wall.z) > (abs(at.z) > 0.5 * halfThickness ? kClearlyFacing : kFacing)) {
        faces.side.z = wall.z < 0.0 ? 1.0 : -1.0;
    }
    if (length(wall.xyz) < kFacing) {
        faces.open = bvec3(false);
    } else if (any(facing)) {
        faces.open = facing;
    }
    return faces;
}

int largest(vec3 v) {
    return v.x >= v.y && v.x >= v.z ? 0 : (v.y >= v.z ? 1 : 2);
}

// The face that stops the way, 3 for none: the last one that it enters through, or the nearest
// where it starts inside, no deeper than `deepest`.
int faceFor(Faces faces, vec3 before, vec3 after, float deepest) {
    if (any(greaterThan(min(before, after), vec3(0.0)))) return 3;
    vec3 when = mix(vec3(-1.0), before / (before - after), greaterThan(before, vec3(0.0)));
    int entered = largest(when);
    if (when[entered] >= 0.0 && faces.open[entered]) {
        vec3 there = mix(before, after, when[entered]);
        there[entered] = 0.0;
        return all(lessThanEqual(there, vec3(0.0))) ? entered : 3;
    }
    vec3 key = mix(vec3(-1e30), before, faces.open);
    int nearest = largest(key);
    after[nearest] = 0.0;
    return key[nearest] > -deepest && all(lessThanEqual(after, vec3(0.0))) ? nearest : 3;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= obstacle.vertex_count || positions[v].w == 0.0) return;
    BladeRecord blade = blades[substep];
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
