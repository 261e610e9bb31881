// What surfaces that touch do to each other in a substep, in four phases with a storage barrier
// between them: what each point and the edges at it touch; an impulse for each contact, added up by
// vertices; another one from where that leaves d; what the vertices make of the sums.
//
// The includer declares `contact` (ContactUniforms), `state`, `records`, `sums`, the share of each
// vertex by takeShare(v, share), shareTaken(v) and clearShare(v), positionOf(v), displacementOf(v),
// setPosition(v, x), setDisplacement(v, d), with UNFOLDS pieceOf(v).
#include "contact_bindings.h"
#include "nearest.glsl"
#include "sim/contact_answer.glsl"
#include "sim/fetch.glsl"
#include "sim/fixed_sums.glsl"
#include "sim/folds.glsl"
#include "sim/lines.glsl"
#include "sim/mass_shares.glsl"
#include "sim/plane_weights.glsl"

STATE_TEXELS(kContactNormalsUnit) contactNormals;
RECORD_WORDS(kContactPointsUnit) contactPoints;
RECORD_WORDS(kContactEdgePairsUnit) contactEdgePairs;

vec3 skinNormalOf(uint v) { return fetch(contactNormals, 2u * v).xyz; }
vec3 wallNormalOf(uint v) { return fetch(contactNormals, 2u * v + 1u).xyz; }
uint pointAt(uint index) { return fetch(contactPoints, index).x; }
EdgePair edgePairAt(uint place) {
    return EdgePair(fetch(contactEdgePairs, 3u * place).x,
                    fetch(contactEdgePairs, 3u * place + 1u).x,
                    uintBitsToFloat(fetch(contactEdgePairs, 3u * place + 2u).x));
}

// What each point with candidates touches: the nearest of its triangles, where it comes nearer than
// it may. Which one is decided at X + d, and the gap is measured at X, before, and by the same
// weights and normal at X + d, after; see contact_answer.glsl. The triangle answers where the line
// of the whole impulse meets its plane at X, so that no torque is left over, as far as the vertex
// is no deeper than the thickness.
// With UNFOLDS folded skin does not touch what was beside it at rest nor its own piece, see
// folds.glsl.

// The corners of a triangle, as seen from the vertex [m].
struct SeenCorners {
    vec3 a;
    vec3 b;
    vec3 c;
};

// Whether one of the two is folded and would be caught by the other.
bool passesFold(uint v, Nearest near) {
#ifdef UNFOLDS
    bool wasBeside = near.thickness < contact.thickness;
    bool ownPiece = pieceOf(v) == near.triangle.w >> 8;
    return (wasBeside || ownPiece) && foldAt(uvec4(v, near.triangle.xyz)) > 0.0;
#else
    return false;
#endif
}

void detectPoint(uint index) {
    uint v = pointAt(index);
    Nearest near = nearest(v);
    vec3 own = positionOf(v).xyz;
    SeenCorners t = SeenCorners(positionOf(near.triangle.x).xyz - own,
                                positionOf(near.triangle.y).xyz - own,
                                positionOf(near.triangle.z).xyz - own);
    vec3 areaNormal = cross(t.b - t.a, t.c - t.a);
    vec3 normal = areaNormal / max(length(areaNormal), 1e-30);
    float before = -dot(normal, t.a);
    vec3 weights = planeWeights(t.a, t.b, t.c, -before * normal);
    vec3 slip = displacementOf(v).xyz -
        (weights.x * displacementOf(near.triangle.x).xyz +
         weights.y * displacementOf(near.triangle.y).xyz +
         weights.z * displacementOf(near.triangle.z).xyz);
    float gap = before + dot(normal, slip);
    ContactRule rule = ContactRule(near.thickness, kHair * contact.h, contact.friction,
                                   contact.lift_speed * contact.substep);
    ContactAnswer answer = answerTo(normal, before, slip, rule);
    float approach = dot(answer.impulse, normal);
    bool touches = (approach > 0.0 || answer.push > 0.0) &&
        lateralDistance(near) <= kLateralSlack * contact.h && gap >= -contact.margin &&
        !passesFold(v, near);
    if (approach > 0.0) {
        float lever = clamp(before, -contact.thickness, contact.thickness);
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
    takeShare(v, shareOf(1.0));
    takeShare(near.triangle.x, shareOf(weights.x));
    takeShare(near.triangle.y, shareOf(weights.y));
    takeShare(near.triangle.z, shareOf(weights.z));
    atomicAdd(state.contacts, 1u);
}

// What the edges at each point touch: of its pairs of edges the one whose gap ends up smallest. The
// gap is measured along the line across both edges at X, which points to the surface of the point;
// both are met where they come nearest to each other at X, so that no torque is left over, and must
// cross there at X + d too. Friction is left to vertices.

struct Crossing {
    uvec4 vertices;
    vec4 gains;
    vec3 normal;
    float before;  // gap at X [m]
    vec3 slip;
    float lack;  // of the thickness at X + d [m]
    float thickness;
};

bool inside(vec2 where, float end) {
    return all(greaterThanEqual(where, vec2(end))) && all(lessThanEqual(where, vec2(1.0 - end)));
}

// Positions are taken from the first vertex, and d apart from X, which is far larger.
Crossing moreUrgent(Crossing best, uint v, EdgePair pair) {
    uvec4 t = triangleAt(pair.edge >> 2);
    uint corner = pair.edge & 3u;
    uvec4 ends = uvec4(v, pair.other, t[corner], t[(corner + 1u) % 3u]);
    vec3 origin = positionOf(v).xyz;
    vec3 u = positionOf(ends.y).xyz - origin;
    vec3 c = positionOf(ends.z).xyz - origin;
    vec3 w = positionOf(ends.w).xyz - origin - c;
    vec3 third = positionOf(t[(corner + 2u) % 3u]).xyz - origin;
    vec3 face = cross(w, third - c);
    vec3 across = cross(u, w);
    float size = length(across);
    if (size < 0.05 * length(u) * length(w)) return best;
    across *= (dot(across, face) < 0.0 ? -1.0 : 1.0) / size;
    if (dot(across, face) < kAcross * length(face)) return best;
    if (min(dot(across, skinNormalOf(v)), dot(across, wallNormalOf(v))) > kOpposed) return best;
    float before = -dot(across, c);
    vec2 where = nearestOnLines(vec3(0.0), u, c, w);
    vec3 da = displacementOf(ends.x).xyz;
    vec3 db = displacementOf(ends.y).xyz;
    vec3 dc = displacementOf(ends.z).xyz;
    vec3 dd = displacementOf(ends.w).xyz;
    vec2 after = nearestOnLines(da, u + (db - da), c + dc, w + (dd - dc));
    bool isBare = pair.thickness <= kBareEdge * contact.h;
    float end = isBare ? kBareEnd : 0.0;
    if (before < -kEdgeDepth * contact.h || !inside(where, end) || !inside(after, end)) return best;
    vec4 gains = vec4(1.0 - where.x, where.x, where.y - 1.0, -where.y);
    vec3 slip = gains.x * da + gains.y * db + gains.z * dc + gains.w * dd;
    float lack = pair.thickness - before - dot(across, slip);
    // Where rims lie on each other vertices carry, which have friction.
    if (!(lack > best.lack) || (isBare && lack < kHair * contact.h)) return best;
    return Crossing(ends, gains, across, before, slip, lack, pair.thickness);
}

void detectEdges(uint index) {
    uint v = pointAt(index);
    Crossing best;
    best.lack = 0.0;
    for (uint k = 0u; k < kEdgePairsPerPoint; ++k) {
        EdgePair pair = edgePairAt(kEdgePairsPerPoint * v + k);
        if (!(pair.thickness > 0.0)) break;
        best = moreUrgent(best, v, pair);
    }
    uint place = state.points + index;
    if (!(best.lack > 0.0)) {
        records[place].v1 = kNoVertex;
        return;
    }
    ContactRule rule =
        ContactRule(best.thickness, 0.0, 0.0, contact.lift_speed * contact.substep);
    ContactAnswer answer = answerTo(best.normal, best.before, best.slip, rule);
    records[place] = ContactRecord(vec4(best.normal, answer.push),
                                   vec4(answer.impulse, answer.least),
                                   best.gains, best.vertices.x, best.vertices.y, best.vertices.z,
                                   best.vertices.w);
    takeShare(best.vertices.x, shareOf(best.gains.x));
    takeShare(best.vertices.y, shareOf(best.gains.y));
    takeShare(best.vertices.z, shareOf(best.gains.z));
    takeShare(best.vertices.w, shareOf(best.gains.w));
    atomicAdd(state.contacts, 1u);
}

// Of d and of X, in all [m].
struct Change {
    vec3 impulse;
    vec3 push;
};

// The words of a vertex in `sums`: of d in the first sweep, of X, and of d in the second.
uint sumOfD(uint v, bool again) {
    return kContactSumWords * v + (again ? 6u : 0u);
}

uint sumOfX(uint v) {
    return kContactSumWords * v + 3u;
}

// d after the first sweep.
vec3 sweptOnce(uint v) {
    return displacementOf(v).xyz + sumAt(sumOfD(v, false), contact.unit);
}

// The second sweep goes on from d as the first one leaves it: impulses add up, and what it did too
// much is taken back. A contact that stops a part of the approach alone leaves a speed that the
// body does not move with, since pushes take the way back.
Change changeBy(uint place, ContactRecord record, float friction, bool again) {
    if (!again) return Change(record.impulse.xyz, record.normal.w * record.normal.xyz);
    vec3 slip = record.gains.x * sweptOnce(record.v0);
    slip += record.gains.y * sweptOnce(record.v1);
    slip += record.gains.z * sweptOnce(record.v2);
    slip += record.gains.w * sweptOnce(record.v3);
    vec3 sum = goOn(record.impulse.xyz, record.normal.xyz, slip, record.impulse.w, friction);
    records[place].impulse.xyz = sum;
    return Change(sum - record.impulse.xyz, vec3(0.0));
}

void addTo(uint v, float gain, Change change, bool again) {
    if (gain == 0.0) return;
    addFixed(sumOfD(v, again), contact.unit, gain * change.impulse);
    if (!again && change.push != vec3(0.0)) addFixed(sumOfX(v), contact.unit, gain * change.push);
}

// Without loops, of which one thread of llvmpipe may turn only so many.
void respondOne(uint place, float friction, bool again) {
    ContactRecord record = records[place];
    if (record.v1 == kNoVertex) return;
    vec4 w = contact.inverse_density *
        vec4(positionOf(record.v0).w, positionOf(record.v1).w, positionOf(record.v2).w,
             positionOf(record.v3).w);
    float weight = w.x * sharedWeight(record.gains.x, shareTaken(record.v0));
    weight += w.y * sharedWeight(record.gains.y, shareTaken(record.v1));
    weight += w.z * sharedWeight(record.gains.z, shareTaken(record.v2));
    weight += w.w * sharedWeight(record.gains.w, shareTaken(record.v3));
    if (!(weight > 0.0)) return;
    Change change = changeBy(place, record, friction, again);
    addTo(record.v0, record.gains.x * w.x / weight, change, again);
    addTo(record.v1, record.gains.y * w.y / weight, change, again);
    addTo(record.v2, record.gains.z * w.z / weight, change, again);
    addTo(record.v3, record.gains.w * w.w / weight, change, again);
}

// Solves each contact at a point once: mass-splitting Jacobi, see mass_shares.glsl. Corrections are
// summed as integers, which do not mind the order in which threads come.
void respondAt(uint index, bool again) {
    respondOne(index, contact.friction, again);
    respondOne(state.points + index, 0.0, again);  // see detectEdges
}

// Adds to a vertex what its contacts sum up to: to d, which becomes velocity, and to X, which does
// not. Clears sums and shares for the next substep.
void applyTo(uint v) {
    if (shareTaken(v) == 0u) return;
    clearShare(v);
    vec3 d = displacementOf(v).xyz + takeSum(sumOfD(v, false), contact.unit);
    setDisplacement(v, vec4(d + takeSum(sumOfD(v, true), contact.unit), 0.0));
    vec4 x = positionOf(v);
    setPosition(v, vec4(x.xyz + takeSum(sumOfX(v), contact.unit), x.w));
}

void endContacts() {
    state.last_contacts = state.contacts;
    state.contacts = 0u;
}
