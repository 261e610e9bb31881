// The angle of a bend, see constraints/bend.glsl.
#pragma once
#include "sim/inverse_tangent.glsl"

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
