// What each vertex meets in a step: an obstacle, and the nearest of its candidate triangles, where
// both are at X + h v. Joins the pieces that may touch.
// Numbers: whether candidates are there. One thread per vertex. A storage barrier follows.
#include "sim/numbers.glsl"
#include "sim/implicit/uniforms.glsl"
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

float firmnessOf(uint v) { return uintBitsToFloat(fetch(firmness, v).x); }

uint rootOf(uint p) {
    while (parents[p] != p) p = parents[p];
    return p;
}

// The root of pieces that touch is the first of them, whoever comes first.
void join(uint a, uint b) {
    a = rootOf(a);
    b = rootOf(b);
    while (a != b) {
        uint high = max(a, b);
        if (atomicCompSwap(parents[high], high, min(a, b)) == high) break;
        a = rootOf(a);
        b = rootOf(b);
    }
}

void setRow(uint row, vec3 normal, float gap, float stiffness, vec3 weights) {
    vec4 kept = fetch(keptSlips, row);
    vec3 slip = kept.xyz - dot(kept.xyz, normal) * normal;
    rows[3u * row] = vec4(normal, gap);
    rows[3u * row + 1u] = vec4(slip, stiffness);
    rows[3u * row + 2u] = vec4(kept.w, weights);
}

void setNone(uint row) { rows[3u * row + 1u] = vec4(0.0); }

void meetFloor(uint v) {
    float gap = positionOf(v).y - implicit.floor_height;
    if (!(gap < implicit.reach - 1.5 * displacementOf(v).y)) {
        setNone(2u * v);
        return;
    }
    setRow(2u * v, vec3(0.0, 1.0, 0.0), gap, firmnessOf(v), vec3(0.0));
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
    float gap = -dot(normal, a) - max(near.thickness, kHair * contact.h);
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
    meetFloor(v);
    if (touchesItself) meetSurface(v, piece);
}
