// What each point with candidates touches in this substep: the nearest of its triangles, where it
// comes nearer than it may. The gap is measured at X + d and, by the same weights and normal, at X:
//
//   approach  what d lacks so that the gap does not shrink below its thickness, or not at all where
//             it is below already: this is taken from the velocity
//   push      what X lacks of the thickness then, at most lift_speed * h: this is not
//
// Reads X, d, candidates. Writes records, how many contacts each vertex is part of, and their number.
// One thread per listed point. A storage barrier follows, then respond.
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kContactUniformsBinding) readonly buffer Uniforms { ContactUniforms uniforms; };
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactDisplacementBinding) readonly buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactCandidatesBinding) readonly buffer Candidates { ContactCandidate candidates[]; };
layout(std430, binding = kContactPointsBinding) readonly buffer Points { uint points[]; };
layout(std430, binding = kContactRecordsBinding) writeonly buffer Records { ContactRecord records[]; };
layout(std430, binding = kContactSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "closest_point.glsl"

struct Nearest {
    uvec4 triangle;
    vec3 weights;
    vec3 normal;  // not of unit length
    vec3 offset;  // from the touched point to the vertex [m]
    float thickness;
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
        if (away < least) {
            least = away;
            best = Nearest(t, weights, cross(b - a, c - a), offset, candidate.thickness);
        }
    }
    return best;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    uint v = points[index];
    Nearest near = nearest(v);
    vec3 normal = near.normal / max(length(near.normal), 1e-30);
    float gap = dot(normal, near.offset);
    vec3 slip = displacement[v].xyz -
        (near.weights.x * displacement[near.triangle.x].xyz +
         near.weights.y * displacement[near.triangle.y].xyz +
         near.weights.z * displacement[near.triangle.z].xyz);
    float before = gap - dot(normal, slip);
    float least = min(before, near.thickness);
    float approach = max(least - gap, 0.0);
    float missing = near.thickness - max(gap, least);
    float inside = -max(gap, least);
    float push = min(max(inside, kThicknessRate * missing), uniforms.lift_speed * uniforms.substep);
    vec3 aside = near.offset - gap * normal;
    bool touches = (approach > 0.0 || push > 0.0) &&
        length(aside) <= kLateralSlack * uniforms.h && gap >= -uniforms.margin;
    ContactRecord record;
    record.normal = vec4(normal, approach);
    record.weights = vec4(near.weights, max(push, 0.0));
    record.v0 = touches ? near.triangle.x : kNoVertex;
    record.v1 = near.triangle.y;
    record.v2 = near.triangle.z;
    record.point = v;
    records[index] = record;
    if (!touches) return;
    atomicAdd(shares[v], 1u);
    atomicAdd(shares[near.triangle.x], 1u);
    atomicAdd(shares[near.triangle.y], 1u);
    atomicAdd(shares[near.triangle.z], 1u);
    atomicAdd(state.contacts, 1u);
}
