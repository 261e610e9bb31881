// A bend:
//
//            v2            e = v1 - v0, nA = e x (v2 - v0), nB = (v3 - v0) x e
//           /  |           theta = atan2((nA x nB) . e / |e|, nA . nB): flat 0, convex > 0
//         v0 -> v1
//           |  /
//            v3
//
// Its energy is in strain_energy.glsl, with how far it is folded.
#include "sim/bend_angle.glsl"

// What the triangle on either side pulls with, along its normal, and where along the edge from v0
// (0) to v1 (1) its apex stands: see bendShare.
struct BendPull {
    vec4 left, right;
};

// Below this a bend has no answer but noise. Where all but one of its vertices are held and lie on
// a line, as at the front of a slit, the last one hardly changes the angle: a rigid bend would
// throw it as far as rounding of the angle over that gradient says. Compliance bounds it.
float leastWeight(vec4 w, vec3 a, vec3 b) {
    float most = uniforms.inverse_density * max(max(w.x, w.y), max(w.z, w.w));
    bool rigid = uniforms.compliance[kBend] <= 0.0;
    return rigid ? kLeastBendShare * most * (dot(a, a) + dot(b, b)) : 0.0;
}

BendPull bendPull(BendRecord bend) {
    vec3 x0 = positionOf(bend.v0).xyz;
    vec3 x1 = positionOf(bend.v1).xyz;
    vec3 x2 = positionOf(bend.v2).xyz;
    vec3 x3 = positionOf(bend.v3).xyz;
    vec4 d0 = displacementOf(bend.v0);
    vec4 d1 = displacementOf(bend.v1);
    vec4 d2 = displacementOf(bend.v2);
    vec4 d3 = displacementOf(bend.v3);
    vec3 edgeStep = d1.xyz - d0.xyz;
    vec3 leftStep = d2.xyz - d0.xyz;
    vec3 rightStep = d3.xyz - d0.xyz;
    Wings before = wingsOf(x1 - x0, x2 - x0, x3 - x0);
    Wings now = wingsOf(before.edge + edgeStep, before.left + leftStep, before.right + rightStep);
    bool slivers = degenerate(now);
    vec2 turn = errorVector(now, bend);
    float error = boundedInverseTangent(turn.y, turn.x);

    bool little = pullsAsBefore() && turnedLittle(before.edge, now.edge) &&
        turnedLittle(before.nA, now.nA) &&
                  turnedLittle(before.nB, now.nB);
    Wings pulled = now;
    if (little && !degenerate(before)) {
        pulled = before;
    }
    float e2 = dot(pulled.edge, pulled.edge);
    float reach = sqrt(e2);
    vec3 a = pulled.nA * (reach / dot(pulled.nA, pulled.nA));
    vec3 b = pulled.nB * (reach / dot(pulled.nB, pulled.nB));
    float sA = dot(pulled.left, pulled.edge) / e2;
    float sB = dot(pulled.right, pulled.edge) / e2;
    vec3 g0 = (1.0 - sA) * a + (1.0 - sB) * b;
    vec3 g1 = sA * a + sB * b;

    vec4 inverseMasses = vec4(d0.w, d1.w, d2.w, d3.w);
    float weight = uniforms.inverse_density *
        dot(inverseMasses, vec4(dot(g0, g0), dot(g1, g1), dot(a, a), dot(b, b)));
    float fold = foldAt(uvec4(bend.v0, bend.v1, bend.v2, bend.v3));
    float compliance = bend.geometry * uniforms.compliance[kBend];
    float gamma = dampingOf(weight, compliance, fold, kBend);
    float denominator = dampedWeight(weight, compliance, gamma, kBend);
    float rate = dot(a, sA * edgeStep - leftStep) + dot(b, sB * edgeStep - rightStep);
    float answered = dampedError(error, rate, gamma, fold, max(length(a), length(b)));
    bool answers = weight > leastWeight(inverseMasses, a, b);
    float impulse = answers ? uniforms.share[kBend] * -answered / denominator : 0.0;
    return BendPull(slivers ? vec4(0.0) : vec4(a * impulse, sA),
                    slivers ? vec4(0.0) : vec4(b * impulse, sB));
}

void solveBend(BendRecord bend, uint index) {
    BendPull pull = bendPull(bend);
    setCorrection(2u * index, pull.left);
    setCorrection(2u * index + 1u, pull.right);
}
