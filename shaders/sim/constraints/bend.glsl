// A bend:
//
//            v2            e = v1 - v0, nA = e x (v2 - v0), nB = (v3 - v0) x e
//           /  |           theta = atan2((nA x nB) . e / |e|, nA . nB): flat 0, convex > 0
//         v0 -> v1
//           |  /
//            v3
//
// Its energy is in measure.comp, with how far it is folded.
// It pulls along its gradient at X + d.
#include "sim/base/bend_angle.glsl"

// What the triangle on either side pulls with, along its normal, and where along the edge from v0
// (0) to v1 (1) its apex stands: see bendShare.
struct BendPull {
    vec4 left, right;
};

// Below this a bend has no answer but noise. Where all but one of its vertices are held and lie on
// a line, as at the front of a slit, the last one hardly changes the angle: the bend would throw it
// as far as rounding of the angle over that gradient says.
float leastWeight(vec4 w, vec3 a, vec3 b) {
    float most = uniforms.inverse_density * max(max(w.x, w.y), max(w.z, w.w));
    return kLeastBendShare * most * (dot(a, a) + dot(b, b));
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
    Wings now = wingsOf(x1 - x0 + (d1.xyz - d0.xyz), x2 - x0 + (d2.xyz - d0.xyz),
                        x3 - x0 + (d3.xyz - d0.xyz));
    bool slivers = degenerate(now);
    vec2 turn = errorVector(now, bend);
    float error = boundedInverseTangent(turn.y, turn.x);
    float e2 = dot(now.edge, now.edge);
    float reach = sqrt(e2);
    vec3 a = now.nA * (reach / dot(now.nA, now.nA));
    vec3 b = now.nB * (reach / dot(now.nB, now.nB));
    float sA = dot(now.left, now.edge) / e2;
    float sB = dot(now.right, now.edge) / e2;
    vec3 g0 = (1.0 - sA) * a + (1.0 - sB) * b;
    vec3 g1 = sA * a + sB * b;

    vec4 inverseMasses = vec4(d0.w, d1.w, d2.w, d3.w);
    float weight = uniforms.inverse_density *
        dot(inverseMasses, vec4(dot(g0, g0), dot(g1, g1), dot(a, a), dot(b, b)));
    bool answers = weight > leastWeight(inverseMasses, a, b);
    float impulse = answers ? uniforms.share[kBend] * -error / weight : 0.0;
    return BendPull(slivers ? vec4(0.0) : vec4(a * impulse, sA),
                    slivers ? vec4(0.0) : vec4(b * impulse, sB));
}

void solveBend(BendRecord bend, uint index) {
    BendPull pull = bendPull(bend);
    setCorrection(2u * index, pull.left);
    setCorrection(2u * index + 1u, pull.right);
}
