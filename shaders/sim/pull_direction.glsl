// Constraints pull along their gradient at X, the beginning of the substep, as SHAKE does: then no
// sweep changes the angular momentum sum X x m d, which the velocities d / h carry on. Where the
// gradient has turned too far meanwhile, as at slivers, the one at X + d is taken.

// In the substep it turned by no more than 60 degrees and kept half of its size.
bool turnedLittle(vec3 before, vec3 now) {
    return dot(before, now) > 0.5 * max(dot(before, before), dot(now, now));
}

vec3 pullDirection(vec3 before, vec3 now) {
    return normalize(turnedLittle(before, now) ? before : now);
}
