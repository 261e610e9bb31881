// What each point with candidates touches in this substep: the nearest of its triangles, where it
// comes nearer than it may. Which one is decided at X + d, and the gap is measured at X, before,
// and by the same weights and normal at X + d, after; see contact_answer.glsl. The triangle answers
// where the line of the whole impulse meets its plane at X, so that no torque is left over, as far
// as the vertex is no deeper than the thickness.
// With UNFOLDS folded skin does not touch what was beside it at rest nor its own piece, see
// folds.glsl.
//
// Reads X, d, candidates, with UNFOLDS folds and links. Writes records, what contacts take of each
// vertex, and their number. One thread per listed point. A storage barrier follows, then respond.
#include "bindings.h"
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactDisplacementBinding) readonly buffer Displacement {
    vec4 displacement[];
};
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactCandidatesBinding) readonly buffer Candidates {
    ContactCandidate candidates[];
};
layout(std430, binding = kContactPointsBinding) readonly buffer Points { uint points[]; };
layout(std430, binding = kContactRecordsBinding) writeonly buffer Records {
    ContactRecord records[];
};
layout(std430, binding = kContactSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#ifdef UNFOLDS
layout(std430, binding = kContactLinksBinding) readonly buffer Links { VertexLinks links[]; };
#endif

#include "closest_point.glsl"
#include "sim/contact_answer.glsl"
#include "sim/fetch.glsl"
#include "sim/folds.glsl"
#include "sim/mass_shares.glsl"
#include "sim/plane_weights.glsl"

struct Nearest {
    uvec4 triangle;
    vec3 offset;      // from the closest point to the vertex [m]
    vec3 areaNormal;  // not of unit length
    float thickness;
};

// The corners of a triangle, as seen from the vertex [m].
struct Corners {
    vec3 a;
    vec3 b;
    vec3 c;
};

// Differences of positions and of displacements are taken apart, since d is far smaller than X.
vec3 span(uint from, uint to) {
    return (positions[to].xyz - positions[from].xyz) +
        (displacement[to].xyz - displacement[from].xyz);
}

Nearest nearest(uint v) {
    Nearest best;
    float least = 1e30;
    for (uint k = 0u; k < kCandidatesPerPoint; ++k) {
        ContactCandidate candidate = candidates[kCandidatesPerPoint * v + k];
        if (candidate.triangle == kNoVertex) break;
        uvec4 t = triangles[candidate.triangle];
        vec3 a = span(v, t.x);
        vec3 b = span(v, t.y);
        vec3 c = span(v, t.z);
        vec3 weights = closestWeights(a, b, c);
        vec3 offset = -(weights.x * a + weights.y * b + weights.z * c);
        float away = dot(offset, offset);
        if (away < kNearerBy * least) {
            least = away;
            best = Nearest(t, offset, cross(b - a, c - a), candidate.thickness);
        }
    }
    return best;
}

// How far beside the triangle the vertex comes to lie [m].
float lateralDistance(Nearest near) {
    vec3 normal = near.areaNormal / max(length(near.areaNormal), 1e-30);
    return length(near.offset - dot(normal, near.offset) * normal);
}

// Whether one of the two is folded and would be caught by the other.
bool passesFold(uint v, Nearest near) {
#ifdef UNFOLDS
    bool wasBeside = near.thickness < uniforms.thickness;
    bool ownPiece = links[v].piece == near.triangle.w >> 8;
    return (wasBeside || ownPiece) && foldAt(uvec4(v, near.triangle.xyz)) > 0.0;
#else
    return false;
#endif
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    uint v = points[index];
    Nearest near = nearest(v);
    vec3 own = positions[v].xyz;
    Corners t = Corners(positions[near.triangle.x].xyz - own, positions[near.triangle.y].xyz - own,
                        positions[near.triangle.z].xyz - own);
    vec3 areaNormal = cross(t.b - t.a, t.c - t.a);
    vec3 normal = areaNormal / max(length(areaNormal), 1e-30);
    float before = -dot(normal, t.a);
    vec3 weights = planeWeights(t.a, t.b, t.c, -before * normal);
    vec3 slip = displacement[v].xyz -
        (weights.x * displacement[near.triangle.x].xyz +
         weights.y * displacement[near.triangle.y].xyz +
         weights.z * displacement[near.triangle.z].xyz);
    float gap = before + dot(normal, slip);
    ContactRule rule = ContactRule(near.thickness, kHair * uniforms.h, uniforms.friction,
                                   uniforms.lift_speed * uniforms.substep);
    ContactAnswer answer = answerTo(normal, before, slip, rule);
    float approach = dot(answer.impulse, normal);
    bool touches = (approach > 0.0 || answer.push > 0.0) &&
        lateralDistance(near) <= kLateralSlack * uniforms.h && gap >= -uniforms.margin &&
        !passesFold(v, near);
    if (approach > 0.0) {
        float lever = clamp(before, -uniforms.thickness, uniforms.thickness);
        vec3 aside = (-lever / approach) * (answer.impulse - approach * normal);
        weights = planeWeights(t.a, t.b, t.c, aside - before * normal);
    }
    ContactRecord record;
    record.normal = vec4(normal, answer.push);
    record.impulse = vec4(answer.impulse, answer.least);
    record.gains = vec4(1.0, -weights);
    record.v0 = v;
    record.v1 = touches ? near.triangle.x : kNoVertex;
    record.v2 = near.triangle.y;
    record.v3 = near.triangle.z;
    records[index] = record;
    if (!touches) return;
    atomicAdd(shares[v], shareOf(1.0));
    atomicAdd(shares[near.triangle.x], shareOf(weights.x));
    atomicAdd(shares[near.triangle.y], shareOf(weights.y));
    atomicAdd(shares[near.triangle.z], shareOf(weights.z));
    atomicAdd(state.contacts, 1u);
}
