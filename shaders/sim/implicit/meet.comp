// What each vertex meets in a step: an obstacle, with MEETS_BOXES boxes among them, and the nearest
// of its candidate triangles, where both are at X + h v. Joins the pieces that may touch.
// Numbers: whether candidates are there. One thread per vertex. A storage barrier follows.
#include "sim/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
#include "box_records.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
STATE_TEXELS(kKeptSlipsUnit) keptSlips;
RECORD_WORDS(kFirmnessUnit) firmness;
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kMeetContactBinding) readonly buffer Contact { ContactUniforms contact; };
layout(std430, binding = kMadeRowsBinding) writeonly buffer Rows { vec4 rows[]; };
layout(std430, binding = kMadeRowVerticesBinding) writeonly buffer Others { uvec4 others[]; };
layout(std430, binding = kParentsBinding) coherent buffer Parents { uint parents[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return implicit.step * fetch(velocities, v); }
#include "sim/contact/nearest.glsl"
#include "sim/implicit/join.glsl"

float firmnessOf(uint v) { return uintBitsToFloat(fetch(firmness, v).x); }

void setRow(uint row, vec3 normal, float gap, float stiffness, vec3 weights) {
    vec4 kept = fetch(keptSlips, row);
    vec3 slip = kept.xyz - dot(kept.xyz, normal) * normal;
    // What was not pressed in has come otherwise, and is let out little by little.
    float pressed = kept.w / stiffness + kLetOut * max(-gap, 0.0);
    rows[3u * row] = vec4(normal, max(gap, -pressed));
    rows[3u * row + 1u] = vec4(slip, stiffness);
    rows[3u * row + 2u] = vec4(kept.w, weights);
}

void setNone(uint row) { rows[3u * row + 1u] = vec4(0.0); }

// An obstacle: along which normal, and how far away at X and at X + h v.
struct Meeting {
    vec3 normal;
    float gap;
    float ahead;
};

Meeting floorFor(uint v) {
    float gap = positionOf(v).y - implicit.floor_height;
    return Meeting(vec3(0.0, 1.0, 0.0), gap, gap + displacementOf(v).y);
}

#ifdef MEETS_BOXES
layout(std430, binding = kMeetObstacleBinding) readonly buffer Obstacle {
    BoxUniforms obstacle;
};
STATE_TEXELS(kMeetBoxesUnit) boxes;
RECORD_WORDS(kMeetPieceBoundsUnit) boundsOfPieces;

uint pieceOf(uint v) { return links[v].piece; }
#include "sim/boxes/fetched.glsl"
#include "sim/boxes/keep_out.glsl"

// The face that a vertex is near and above, where its way enters none: elasticity may take it
// there.
Face faceBelow(BoxRecord box, vec3 at) {
    vec3 outside = abs(at) - halfOf(box) - obstacle.thickness;
    int axis = largest(outside);
    bool near = outside[axis] >= 0.0 && outside[axis] < implicit.reach;
    outside[axis] = 0.0;
    bool above = near && all(lessThanEqual(outside, vec3(0.0)));
    return Face(above ? axis : 3, sideOf(at[axis]), 0.0, false);
}

Meeting nearerBox(Meeting best, uint v) {
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
        if (ahead < best.ahead) best = Meeting(fromBox(box, normal), gap, ahead);
    }
    return best;
}
#else
Meeting nearerBox(Meeting best, uint v) { return best; }
#endif

void meetObstacle(uint v) {
    Meeting met = nearerBox(floorFor(v), v);
    if (!(met.ahead < implicit.reach + 0.5 * (met.gap - met.ahead))) {
        setNone(2u * v);
        return;
    }
    setRow(2u * v, met.normal, met.gap, firmnessOf(v), vec3(0.0));
    others[2u * v] = uvec4(kNoPiece, 0u, 0u, 0u);
}

void meetSurface(uint v, uint piece) {
    uint row = 2u * v + 1u;
    Nearest near = nearest(v);
    bool meets = dot(near.weights, vec3(1.0)) > 0.5 &&
        lateralDistance(near) <= kLateralSlack * contact.h;
    if (!meets) {
        setNone(row);
        return;
    }
    uvec4 t = near.triangle;
    vec3 own = positionOf(v).xyz;
    vec3 a = positionOf(t.x).xyz - own;
    vec3 areaNormal = cross(positionOf(t.y).xyz - own - a, positionOf(t.z).xyz - own - a);
    vec3 normal = areaNormal / max(length(areaNormal), 1e-30);
    float gap = -dot(normal, a) - near.thickness;
    float point = firmnessOf(v);
    float yielding = near.weights.x * firmnessOf(t.x) + near.weights.y * firmnessOf(t.y) +
        near.weights.z * firmnessOf(t.z);
    setRow(row, normal, gap, 2.0 * point * yielding / (point + yielding), -near.weights);
    others[row] = uvec4(t.w >> 8, t.xyz);
    join(piece, t.w >> 8);
}

bool touchesItself = numbers.x != 0u;

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    uint piece = links[v].piece;
    setNone(2u * v + 1u);
    if (piece == kNoPiece) {
        setNone(2u * v);
        return;
    }
    meetObstacle(v);
    if (touchesItself) meetSurface(v, piece);
}
