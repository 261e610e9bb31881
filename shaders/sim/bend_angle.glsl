// The angle of a bend, see bend.comp.
#include "sim/inverse_tangent.glsl"

float wrapped(float angle) {
    const float kTwoPi = 6.28318530717959;
    return angle > 0.5 * kTwoPi ? angle - kTwoPi : (angle < -0.5 * kTwoPi ? angle + kTwoPi : angle);
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

float angleOf(Wings w) {
    return inverseTangent(dot(cross(w.nA, w.nB), w.edge) / length(w.edge), dot(w.nA, w.nB));
}
