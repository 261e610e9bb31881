// How far the skin at a bend is folded: 0 to 1. The includer declares `restPositions`.
#include "sim/base/bend_angle.glsl"

// From the error vector of the bend (bend_angle.glsl).
float turnedOver(vec2 turn) {
    float size = length(turn);
    float cosine = size > 0.0 ? turn.x / size : 1.0;
    return clamp((kFoldBegins - cosine) / (kFoldBegins - kFoldEnds), 0.0, 1.0);
}

float areaShare(vec3 now, vec3 rest) {
    return sqrt(dot(now, now) / max(dot(rest, rest), 1e-37));
}

// The more squashed one of both triangles. A thin one is squashed to a line within its plane, where
// no bend turns, and comes out on the other side.
float squashed(Wings now, Wings rest) {
    float least = min(areaShare(now.nA, rest.nA), areaShare(now.nB, rest.nB));
    return clamp((kSquashBegins - least) / (kSquashBegins - kSquashEnds), 0.0, 1.0);
}

Wings restWingsOf(BendRecord bend) {
    vec3 from = fetch(restPositions, bend.v0).xyz;
    return wingsOf(fetch(restPositions, bend.v1).xyz - from,
                   fetch(restPositions, bend.v2).xyz - from,
                   fetch(restPositions, bend.v3).xyz - from);
}

float foldOf(Wings now, BendRecord bend) {
    float turned = degenerate(now) ? 0.0 : turnedOver(errorVector(now, bend));
    return max(turned, squashed(now, restWingsOf(bend)));
}
