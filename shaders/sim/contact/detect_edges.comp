// What the edges at each point touch in this substep: of its pairs of edges the one whose gap ends
// up smallest. The gap is measured along the line across both edges at X, which points to the
// surface of the point; both are met where they come nearest to each other at X, so that no torque
// is left over, and must cross there at X + d too. Friction is left to vertices.
// Reads X, d, triangles, normals, pairs. Writes the records behind those of the points, what
// contacts take of each vertex, and their number. One thread per listed point. A storage barrier
// follows, then respond.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactEdgePairsBinding) readonly buffer Pairs { EdgePair pairs[]; };
layout(std430, binding = kContactDisplacementBinding) readonly buffer Displacement {
    vec4 displacement[];
};
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactNormalsBinding) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = kContactPointsBinding) readonly buffer Points { uint points[]; };
layout(std430, binding = kContactRecordsBinding) writeonly buffer Records {
    ContactRecord records[];
};
layout(std430, binding = kContactSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "sim/contact_answer.glsl"
#include "sim/lines.glsl"
#include "sim/mass_shares.glsl"

struct Crossing {
    uvec4 vertices;
    vec4 gains;
    vec3 normal;
    float before;  // gap at X [m]
    vec3 slip;
    float lack;  // of the thickness at X + d [m]
    float thickness;
};

bool inside(vec2 where) {
    return all(greaterThanEqual(where, vec2(0.0))) && all(lessThanEqual(where, vec2(1.0)));
}

// Positions are taken from the first vertex, and d apart from X, which is far larger.
Crossing moreUrgent(Crossing best, uint v, EdgePair pair) {
    uvec4 t = triangles[pair.edge >> 2];
    uint corner = pair.edge & 3u;
    uvec4 ends = uvec4(v, pair.other, t[corner], t[(corner + 1u) % 3u]);
    vec3 origin = positions[v].xyz;
    vec3 u = positions[ends.y].xyz - origin;
    vec3 c = positions[ends.z].xyz - origin;
    vec3 w = positions[ends.w].xyz - origin - c;
    vec3 third = positions[t[(corner + 2u) % 3u]].xyz - origin;
    vec3 face = cross(w, third - c);
    vec3 across = cross(u, w);
    float size = length(across);
    if (size < 0.05 * length(u) * length(w)) return best;
    across *= (dot(across, face) < 0.0 ? -1.0 : 1.0) / size;
    if (dot(across, face) < kAcross * length(face)) return best;
    if (dot(across, normals[v].xyz) > kOpposed) return best;
    float before = -dot(across, c);
    vec2 where = nearestOnLines(vec3(0.0), u, c, w);
    vec3 da = displacement[ends.x].xyz;
    vec3 db = displacement[ends.y].xyz;
    vec3 dc = displacement[ends.z].xyz;
    vec3 dd = displacement[ends.w].xyz;
    vec2 after = nearestOnLines(da, u + (db - da), c + dc, w + (dd - dc));
    if (before < -kEdgeDepth * uniforms.h || !inside(where) || !inside(after)) return best;
    vec4 gains = vec4(1.0 - where.x, where.x, where.y - 1.0, -where.y);
    vec3 slip = gains.x * da + gains.y * db + gains.z * dc + gains.w * dd;
    float lack = pair.thickness - before - dot(across, slip);
    if (!(lack > best.lack)) return best;
    return Crossing(ends, gains, across, before, slip, lack, pair.thickness);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= state.points) return;
    uint v = points[index];
    Crossing best;
    best.lack = 0.0;
    for (uint k = 0u; k < kEdgePairsPerPoint; ++k) {
        EdgePair pair = pairs[kEdgePairsPerPoint * v + k];
        if (pair.other == kNoVertex) break;
        best = moreUrgent(best, v, pair);
    }
    uint place = state.points + index;
    if (!(best.lack > 0.0)) {
        records[place].v1 = kNoVertex;
        return;
    }
    ContactRule rule =
        ContactRule(best.thickness, 0.0, 0.0, uniforms.lift_speed * uniforms.substep);
    ContactAnswer answer = answerTo(best.normal, best.before, best.slip, rule);
    records[place] = ContactRecord(vec4(best.normal, answer.push),
                                   vec4(answer.impulse, answer.least),
                                   best.gains, best.vertices.x, best.vertices.y, best.vertices.z,
                                   best.vertices.w);
    for (int k = 0; k < 4; ++k) {
        atomicAdd(shares[best.vertices[k]], shareOf(best.gains[k]));
    }
    atomicAdd(state.contacts, 1u);
}
