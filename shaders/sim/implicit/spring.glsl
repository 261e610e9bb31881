// A spring at X: an edge or an ISPC.
struct Spring {
    vec3 root;     // direction * sqrt(stiffness along it less that across)
    float across;  // root of the stiffness across it, where it is stretched or crushed
    float pull;    // force over the first root
};

Spring springOf(vec3 span, float restLength, float stiffness) {
    float reach = length(span);
    float error = reach - restLength;
    float turns = max(error, -error - kMostBuckling * restLength) / max(reach, 1e-12);
    float across = stiffness * clamp(turns, 0.0, kMostAcross);
    float root = sqrt(stiffness * (1.0 + implicit.damping) - across);
    bool acts = reach > 1e-12 && stiffness > 0.0;
    return Spring(acts ? span * (root / reach) : vec3(0.0), acts ? sqrt(across) : 0.0,
                  acts ? stiffness * error / root : 0.0);
}

void setFactor(uint at, Spring spring, float weight) {
    storeFactor(at, weight * vec4(spring.root, spring.across));
}
