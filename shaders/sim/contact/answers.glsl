// What surfaces that touch do to each other in a substep, in four phases with a storage barrier
// between them: what each point and the edges at it touch; an impulse for each contact, added up by
// vertices; another one from where that leaves d; what the vertices make of the sums.
//
// The includer declares `contact` (ContactUniforms), `state`, `records`, `sums`, the share of each
// vertex by takeShare(v, share), shareTaken(v) and clearShare(v), positionOf(v), displacementOf(v),
// setPosition(v, x), setDisplacement(v, d).
#include "contact_bindings.h"
#include "crossing.glsl"
#include "sim/base/contact_answer.glsl"
#include "sim/base/fetch.glsl"
#include "sim/base/fixed_sums.glsl"
#include "sim/base/mass_shares.glsl"
#include "sim/base/plane_weights.glsl"

RECORD_WORDS(kContactPointsUnit) contactPoints;

uint pointAt(uint index) { return fetch(contactPoints, index).x; }

// What each point with candidates touches: the nearest of its triangles, where it comes nearer than
// it may. Which one is decided at X + d, and the gap is measured at X, before, and by the same
// weights and normal at X + d, after; see contact_answer.glsl. The triangle answers where the line
// of the whole impulse meets its plane at X, so that no torque is left over, as far as the vertex
// is no deeper than the thickness.

// The corners of a triangle, as seen from the vertex [m].
struct SeenCorners {
    vec3 a;
    vec3 b;
    vec3 c;
};

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
        lateralDistance(near) <= kLateralSlack * contact.h && gap >= -contact.margin;
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

// What the edges at each point touch.
void detectEdges(uint index) {
    uint v = pointAt(index);
    Crossing best = mostUrgent(v, 0.0);
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
