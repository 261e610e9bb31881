// To which faces of the body of the blade a vertex answers.
//
// The walls of the slit that the edge has just cut start in the middle of the plate: their outward
// normals say to which of the flat sides they belong. Where walls of both sides meet, as at the
// front and at the end of a slit, nothing is pushed. Skin belongs to the side that it is on.
// The includer declares triangleAt(t), triangles around each vertex by rangeAt(v), incidentAt(k),
// X before any was pushed by aroundAt(v).
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
    IncidenceRange range = rangeAt(v);
    uint end = wanted ? range.end : range.first;
    vec3 sum = vec3(0.0);
    float size = 0.0;
    for (uint k = range.first; k < end; ++k) {
        uvec4 t = triangleAt(incidentAt(k) / 4u);
        if ((t.w & 1u) == 0u) continue;
        vec3 a = aroundAt(t.x);
        vec3 area = cross(aroundAt(t.y) - a, aroundAt(t.z) - a);
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
