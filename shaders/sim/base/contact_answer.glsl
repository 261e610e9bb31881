#pragma once
// How two surfaces answer to each other in a substep.
struct ContactAnswer {
    vec3 impulse;  // how d of the one is to change against d of the other [m]
    float least;   // what the gap may change by d at least: not below 0 but by what is left [m]
    float push;    // how far X is to be pushed apart along the normal [m]
};

// What two surfaces keep to.
struct ContactRule {
    float thickness;  // distance that they keep [m]
    float hair;       // up to here what is stopped of the approach is kept as a gap [m]
    float friction;   // Coulomb coefficient
    float most;       // that X is pushed by [m]
};

// before: gap at X; slip: change of the distance vector by d. What d lacks so that the gap does not
// shrink below its thickness, or not at all where it is below already, is taken from the velocity;
// what X lacks of the thickness then is not, and at most `most` of it is made up for. Where
// surfaces lie on each other a few sweeps stop the approach but for a part, which would take them
// into each other: so they keep a gap as wide as what was stopped, up to a hair. Coulomb friction
// holds the tangential way by at most friction * what was stopped.
ContactAnswer answerTo(vec3 normal, float before, vec3 slip, ContactRule rule) {
    // Not as a difference of gaps: below the thickness it is the slip alone, to its last digit.
    float least = min(max(rule.thickness, rule.hair) - before, 0.0);
    float approach = max(least - dot(normal, slip), 0.0);
    float reached = before + dot(normal, slip) + approach;
    float lack =
        max(min(approach, rule.hair) - reached, kThicknessRate * (rule.thickness - reached));
    float push = clamp(lack, 0.0, rule.most);
    vec3 along = slip - dot(normal, slip) * normal;
    float way = length(along);
    float held = min(way, rule.friction * approach);
    vec3 impulse = approach * normal - (way > 0.0 ? held / way : 0.0) * along;
    return ContactAnswer(impulse, least, push);
}

// The impulse so far and what slip still asks for: never a pull, and no more friction than the sum
// along the normal allows.
vec3 goOn(vec3 soFar, vec3 normal, vec3 slip, float least, float friction) {
    float pressed = max(dot(normal, soFar - slip) + least, 0.0);
    vec3 along = soFar - slip;
    along -= dot(normal, along) * normal;
    float way = length(along);
    float held = min(way, friction * pressed);
    return pressed * normal + (way > 0.0 ? held / way : 0.0) * along;
}
