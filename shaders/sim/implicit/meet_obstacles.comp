// What of boxes, or with BLADE of the body of the blade, vertices and triangles meet in a step
// where all is at X + h v: the face that each vertex enters or is near, unless it comes nearer to
// what it meets already; and the corner or edge to which the triangles that begin at it come
// nearest. Each triangle begins at one of its vertices.
// Numbers: the substep. One thread per vertex. A storage barrier follows.
#include "sim/base/numbers.glsl"
#include "blade_records.h"
#include "implicit_records.h"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kMeetObstacleBinding) readonly buffer Obstacle { BoxUniforms obstacle; };
layout(std430, binding = kMadeRowsBinding) buffer Rows { vec4 rows[]; };
#include "sim/implicit/made_rows.glsl"
STATE_TEXELS(kMeetBoxesUnit) boxes;
RECORD_QUADS(kMeetTrianglesUnit) triangles;
RECORD_PAIRS(kMeetRangesUnit) ranges;
RECORD_WORDS(kMeetIncidenceUnit) incidence;

uvec4 triangleAt(uint t) { return fetch(triangles, t); }
IncidenceRange rangeAt(uint v) {
    uvec2 range = fetch(ranges, v).xy;
    return IncidenceRange(range.x, range.y);
}
uint incidentAt(uint k) { return fetch(incidence, k).x; }

// A face: along which normal, how far away at X and at X + h v.
struct Meeting {
    vec3 normal;
    float gap;
    float ahead;
    vec3 lead;
    bool slides;
};
const float kFar = 1e30;

#include "sim/boxes/boxes.glsl"
#ifdef BLADE
BladeRecord bladeNow() {
    uint at = 7u * numbers.x;
    BoxRecord box = BoxRecord(fetch(boxes, at), fetch(boxes, at + 1u), fetch(boxes, at + 2u),
                              fetch(boxes, at + 3u));
    return BladeRecord(box, fetch(boxes, at + 4u), fetch(boxes, at + 5u), fetch(boxes, at + 6u));
}
vec3 aroundAt(uint v) { return positionOf(v).xyz; }
#include "sim/boxes/blade_faces.glsl"

const float kNone = kOfBlade;

bool slides(uvec4 t) { return (t.w & 1u) != 0u; }

Meeting nearestFace(uint v) {
    Meeting none = Meeting(vec3(0.0), 0.0, kFar, vec3(0.0), false);
    BladeRecord blade = bladeNow();
    vec3 x = positionOf(v).xyz;
    vec3 lead = wayOfBlade(blade, x);
    vec3 at = toBox(blade.box, x - blade.box.center.xyz);
    vec3 way = toBox(blade.box, displacementOf(v).xyz - lead);
    bool near = mayMeet(blade, at, at + way);
    vec4 wall = wallNormal(v, near);
    if (!near) return none;
    wall.xyz = toBox(blade.box, wall.xyz);
    Faces faces = facesFor(wall, at, blade.turn.w);
    vec3 before = gapsAt(blade, at, faces.side);
    vec3 after = gapsAt(blade, at + way, faces.side);
    int face = faceFor(faces, before, after, 2.1 * blade.turn.w);
    if (face == 3) return none;
    vec3 normal = vec3(0.0);
    normal[face] = faces.side[face];
    // The bevel comes nearer also where it slides along.
    float widening = before[face] + normal[face] * way[face] - after[face];
    normal = fromBox(blade.box, normal);
    return Meeting(normal, before[face], after[face], lead + widening * normal, wall.w != 0.0);
}

vec3 leadAt(vec3 x) { return wayOfBlade(bladeNow(), x); }
#else
RECORD_WORDS(kMeetPieceBoundsUnit) boundsOfPieces;

uint pieceOf(uint v) { return links[v].piece; }
BoxRecord boxAt(uint b) {
    return BoxRecord(fetch(boxes, 4u * b), fetch(boxes, 4u * b + 1u), fetch(boxes, 4u * b + 2u),
                     fetch(boxes, 4u * b + 3u));
}
uint boundAt(uint p, uint k) { return fetch(boundsOfPieces, 6u * p + k).x; }
PieceBounds pieceBounds(uint p) {
    return PieceBounds(boundAt(p, 0u), boundAt(p, 1u), boundAt(p, 2u), boundAt(p, 3u),
                       boundAt(p, 4u), boundAt(p, 5u));
}
#include "sim/boxes/keep_out.glsl"

const float kNone = kOfObstacle;

bool slides(uvec4 t) { return false; }

// The face that a vertex is near and above, where its way enters none: elasticity may take it
// there.
Face faceBelow(BoxRecord box, vec3 at) {
    vec3 outside = abs(at) - halfOf(box) - obstacle.thickness;
    int axis = largest(outside);
    bool near = outside[axis] >= 0.0 && outside[axis] < implicit.contact.reach;
    outside[axis] = 0.0;
    bool above = near && all(lessThanEqual(outside, vec3(0.0)));
    return Face(above ? axis : 3, sideOf(at[axis]), 0.0, false);
}

Meeting nearestFace(uint v) {
    Meeting best = Meeting(vec3(0.0), 0.0, kFar, vec3(0.0), false);
    for (uint b = 0u; b < obstacle.box_count; ++b) {
        BoxRecord box = boxAt(b);
        vec3 at = toBox(box, positionOf(v).xyz - box.center.xyz);
        vec3 way = toBox(box, displacementOf(v).xyz);
        Face face = faceFor(box, v, at, way);
        if (face.axis == 3) face = faceBelow(box, at + way);
        if (face.axis == 3) continue;
        vec3 normal = vec3(0.0);
        normal[face.axis] = face.side;
        float gap = face.side * at[face.axis] - halfOf(box)[face.axis] - obstacle.thickness;
        float ahead = gap + dot(normal, way);
        if (ahead < best.ahead) {
            best = Meeting(fromBox(box, normal), gap, ahead, vec3(0.0), false);
        }
    }
    return best;
}

vec3 leadAt(vec3 x) { return vec3(0.0); }
#endif
#include "sim/boxes/touch.glsl"

// Where the gap of a row is at X + h v.
float aheadOf(uint row, uint v) {
    if (!(rows[kRowTexels * row + 1u].w > 0.0)) return kFar;
    vec4 normal = rows[kRowTexels * row];
    return normal.w + dot(normal.xyz, displacementOf(v).xyz - rows[kRowTexels * row + 3u].xyz);
}

void meetFace(uint v) {
    uint row = kRowsOfVertex * v + kMeetsObstacle;
    Meeting met = nearestFace(v);
    float within = implicit.contact.reach + 0.5 * (met.gap - met.ahead);
    bool meets = met.ahead < min(aheadOf(row, v), within);
    if (!meets) return;
    setRow(row, Met(met.normal, met.gap, firmnessOf(v), vec4(kNone, vec3(0.0)), met.lead,
                    met.slides, kLetOut));
    vertices[row] = uvec4(v);
}

// A touch of any of the boxes, and of which triangle.
struct Cornered {
    vec3 normal;
    Touch touch;
    uvec4 triangle;
};

Cornered nearestCorner(uint v) {
    Cornered best;
    best.touch.gap = obstacle.thickness + implicit.contact.reach;
    IncidenceRange range = rangeAt(v);
    for (uint k = range.first; k < range.end; ++k) {
        uint corner = incidentAt(k);
        if ((corner & 3u) != 0u) continue;
        uvec4 t = triangleAt(corner / 4u);
        for (uint b = 0u; b < obstacle.box_count; ++b) {
            BoxRecord box = boxAt(b);
            Touch touch = touchOf(box, cornersIn(box, t.xyz), t, best.touch.gap);
            if (touch.gap < best.touch.gap) best = Cornered(fromBox(box, touch.normal), touch, t);
        }
    }
    return best;
}

void meetCorner(uint v) {
    uint row = kRowsOfVertex * v + kMeetsCorner;
    Cornered met = nearestCorner(v);
    if (!(met.touch.gap < obstacle.thickness + implicit.contact.reach)) return;
    if (!(met.touch.gap < aheadOf(row, v) + obstacle.thickness)) return;
    uvec4 t = met.triangle;
    vec3 weights = met.touch.weights;
    vec3 x = weights.x * positionOf(t.x).xyz + weights.y * positionOf(t.y).xyz +
        weights.z * positionOf(t.z).xyz;
    setRow(row, Met(met.normal, met.touch.before - obstacle.thickness, firmnessOf(t.xyz, weights),
                    vec4(kNone, weights.yz, 0.0), leadAt(x), slides(t), kLetOut));
    vertices[row] = uvec4(t.xyz, v);
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count || links[v].piece == kNoPiece) return;
    meetFace(v);
    meetCorner(v);
}
