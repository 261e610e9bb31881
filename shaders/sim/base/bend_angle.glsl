// The angle of a bend, see constraints/bend.glsl.
#pragma once

// Drivers' atan is good to 2e-5 at best; rest angles come from the CPU, so such an error would be
// a standing force. Own polynomial on [0, tan(pi/8)] (interpolated at Chebyshev nodes, 3e-9).
float tangentSeries(float a) {
    float z = a * a;
    float series = -0.3333333134651184 +
        z * (0.19999539852142334 +
        z * (-0.14263956248760223 + z * (0.10743731260299683 + z * -0.06451927870512009)));
    return a + a * z * series;
}

float inverseTangent(float y, float x) {
    const float kPi = 3.14159265358979;
    float longer = max(abs(x), abs(y));
    if (longer == 0.0) {
        return 0.0;
    }
    float ratio = min(abs(x), abs(y)) / longer;
    bool folded = ratio > 0.4142135623731;  // tan(pi/8)
    float angle = tangentSeries(folded ? (ratio - 1.0) / (ratio + 1.0) : ratio) +
        (folded ? 0.25 * kPi : 0.0);
    angle = abs(y) > abs(x) ? 0.5 * kPi - angle : angle;
    angle = x < 0.0 ? kPi - angle : angle;
    return y < 0.0 ? -angle : angle;
}

// The same, at most kMaxBendError to either side.
float boundedInverseTangent(float y, float x) {
    const float kSlope = 0.3093362496096232;  // tan(kMaxBendError)
    bool inside = abs(y) < kSlope * x;
    float angle = tangentSeries(y / (inside ? x : 1.0));
    return inside ? angle : (y < 0.0 ? -kMaxBendError : kMaxBendError);
}

struct Wings {
    vec3 edge, left, right;  // from v0
    vec3 nA, nB;
};

Wings wingsOf(vec3 edge, vec3 left, vec3 right) {
    return Wings(edge, left, right, cross(edge, left), cross(right, edge));
}

bool degenerate(Wings w) {
    float e2 = dot(w.edge, w.edge);
    float least = 1e-8 * e2 * e2;
    return dot(w.nA, w.nA) <= least || dot(w.nB, w.nB) <= least || !(e2 > 0.0);
}

// A vector at the angle theta - rest, from cosine and sine of both, times |nA| |nB|:
// (nA x nB) . e / |e| = -|e| nA . right.
vec2 errorVector(Wings w, BendRecord bend) {
    float sine = -length(w.edge) * dot(w.nA, w.right);
    float cosine = dot(w.nA, w.nB);
    return vec2(cosine * bend.rest_cosine + sine * bend.rest_sine,
                sine * bend.rest_cosine - cosine * bend.rest_sine);
}
