// What follows where corners and edges of boxes meet triangles (touch.glsl): how a gap becomes a
// change of d and a push of X is said in contact_answer.glsl. Of all boxes the most urgent touch of
// each triangle is kept, where the gap ends up smallest.
//
// The includer declares what touch.glsl wants, `touches`, `sums`, the share of each vertex by
// takeShare(v, share), shareTaken(v) and clearShare(v), setPosition(v, x), setDisplacement(v, d),
// triangleAt(t).
#include "sim/base/contact_answer.glsl"
#include "sim/base/fixed_sums.glsl"
#include "sim/base/mass_shares.glsl"
#include "touch.glsl"

BoxTouch recordOf(BoxRecord box, Touch touch) {
    ContactRule rule = ContactRule(obstacle.thickness, 0.0, obstacle.friction, obstacle.push);
    ContactAnswer answer = answerTo(touch.normal, touch.before, touch.slip, rule);
    return BoxTouch(vec4(fromBox(box, touch.normal), answer.push),
                    vec4(fromBox(box, answer.impulse), 1.0), vec4(touch.weights, 0.0));
}

void touchTriangle(uint index) {
    uvec4 t = triangleAt(index);
    BoxTouch record = BoxTouch(vec4(0.0), vec4(0.0), vec4(0.0));
    float least = obstacle.thickness;
    for (uint b = 0u; b < obstacle.box_count; ++b) {
        BoxRecord box = boxAt(b);
        Touch touch = touchOf(box, cornersIn(box, t.xyz), t, least);
        if (touch.gap < least) {
            least = touch.gap;
            record = recordOf(box, touch);
        }
    }
    touches[index] = record;
    if (record.impulse.w == 0.0) return;
    takeShare(t.x, shareOf(record.weights.x));
    takeShare(t.y, shareOf(record.weights.y));
    takeShare(t.z, shareOf(record.weights.z));
}

void addTouch(uint v, float gain, BoxTouch record) {
    if (gain == 0.0) return;
    addFixed(6u * v, obstacle.unit, gain * record.impulse.xyz);
    addFixed(6u * v + 3u, obstacle.unit, gain * record.normal.w * record.normal.xyz);
}

// Solves the touch of a triangle once: mass-splitting Jacobi, see mass_shares.glsl.
void respondTriangle(uint index) {
    BoxTouch record = touches[index];
    if (record.impulse.w == 0.0) return;
    uvec3 t = triangleAt(index).xyz;
    vec3 b = record.weights.xyz;
    vec3 w = obstacle.inverse_density *
        vec3(positionOf(t.x).w, positionOf(t.y).w, positionOf(t.z).w);
    float weight = w.x * sharedWeight(b.x, shareTaken(t.x));
    weight += w.y * sharedWeight(b.y, shareTaken(t.y));
    weight += w.z * sharedWeight(b.z, shareTaken(t.z));
    if (!(weight > 0.0)) return;
    addTouch(t.x, b.x * w.x / weight, record);
    addTouch(t.y, b.y * w.y / weight, record);
    addTouch(t.z, b.z * w.z / weight, record);
}

// Adds to d and X of a vertex what its touches sum up to, and clears the sums for the next substep.
void applyTouches(uint v) {
    if (shareTaken(v) == 0u) return;
    clearShare(v);
    setDisplacement(v, vec4(displacementOf(v).xyz + takeSum(6u * v, obstacle.unit), 0.0));
    vec4 x = positionOf(v);
    setPosition(v, vec4(x.xyz + takeSum(6u * v + 3u, obstacle.unit), x.w));
}
