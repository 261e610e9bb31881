// A bend: see constraints/bend.glsl and ConstraintPull.
#include "sim/bend_angle.glsl"

void setFactors(uint index, uint first) {
    BendRecord bend = fetchBend(records, index);
    vec3 x0 = placeOf(bend.v0);
    Wings wings = wingsOf(placeOf(bend.v1) - x0, placeOf(bend.v2) - x0, placeOf(bend.v3) - x0);
    bool slivers = degenerate(wings);
    float e2 = slivers ? 1.0 : dot(wings.edge, wings.edge);
    float reach = sqrt(e2);
    vec3 a = wings.nA * (reach / (slivers ? 1.0 : dot(wings.nA, wings.nA)));
    vec3 b = wings.nB * (reach / (slivers ? 1.0 : dot(wings.nB, wings.nB)));
    float sA = dot(wings.left, wings.edge) / e2;
    float sB = dot(wings.right, wings.edge) / e2;
    vec3 g0 = (1.0 - sA) * a + (1.0 - sB) * b;
    vec3 g1 = sA * a + sB * b;
    float steepest = max(max(dot(g0, g0), dot(g1, g1)), max(dot(a, a), dot(b, b)));

    vec2 turn = errorVector(wings, bend);
    float error = inverseTangent(turn.y, turn.x);
    float size = abs(error);
    float secant = size > kMaxBendError ? kMaxBendError / size : 1.0;
    float value = clamp(error, -kMaxBendError, kMaxBendError);
    float stiffness = implicit.modulus[kBend] / bend.geometry *
        min(1.0, kMostSteepness * bend.steepness / max(steepest, 1e-30));
    float root = slivers ? 0.0 : sqrt(stiffness * (secant + implicit.damping));
    uint at = first + 4u * index;
    storeFactor(at, vec4(root * g0, 0.0));
    storeFactor(at + 1u, vec4(root * g1, 0.0));
    storeFactor(at + 2u, vec4(-root * a, 0.0));
    storeFactor(at + 3u, vec4(-root * b, 0.0));
    setPull(at, root > 0.0 ? stiffness * value / root : 0.0);
}
