// A bend: see constraints/bend.glsl and ConstraintPull.
#include "sim/bend_angle.glsl"

void setFactors(uint index, uint first) {
    BendRecord bend = fetchBend(records, index);
    vec4 x0 = fetch(positions, bend.v0);
    vec4 x1 = fetch(positions, bend.v1);
    vec4 x2 = fetch(positions, bend.v2);
    vec4 x3 = fetch(positions, bend.v3);
    Wings wings = wingsOf(x1.xyz - x0.xyz, x2.xyz - x0.xyz, x3.xyz - x0.xyz);
    bool slivers = degenerate(wings);
    float e2 = slivers ? 1.0 : dot(wings.edge, wings.edge);
    float reach = sqrt(e2);
    vec3 a = wings.nA * (reach / (slivers ? 1.0 : dot(wings.nA, wings.nA)));
    vec3 b = wings.nB * (reach / (slivers ? 1.0 : dot(wings.nB, wings.nB)));
    float sA = dot(wings.left, wings.edge) / e2;
    float sB = dot(wings.right, wings.edge) / e2;
    vec3 g0 = (1.0 - sA) * a + (1.0 - sB) * b;
    vec3 g1 = sA * a + sB * b;
    vec4 squares = vec4(dot(g0, g0), dot(g1, g1), dot(a, a), dot(b, b));
    float steepest = max(max(squares.x, squares.y), max(squares.z, squares.w));

    vec2 turn = errorVector(wings, bend);
    float error = inverseTangent(turn.y, turn.x);
    float size = abs(error);
    float secant = size > kMaxBendError ? kMaxBendError / size : 1.0;
    float value = clamp(error, -kMaxBendError, kMaxBendError);
    float stiffness = implicit.modulus[kBend] / bend.geometry *
        min(1.0, kMostSteepness * bend.steepness / max(steepest, 1e-30));
    stiffness = boundedFirmness(stiffness, dot(squares, vec4(x0.w, x1.w, x2.w, x3.w)));
    float root = slivers ? 0.0 : sqrt(stiffness * (secant + implicit.damping));
    uint at = first + 4u * index;
    storeFactor(at, vec4(root * g0, 0.0));
    storeFactor(at + 1u, vec4(root * g1, 0.0));
    storeFactor(at + 2u, vec4(-root * a, 0.0));
    storeFactor(at + 3u, vec4(-root * b, 0.0));
    setPull(at, root > 0.0 ? stiffness * value / root : 0.0);
}
