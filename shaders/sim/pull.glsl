// d of a vertex that a hand pulls, a force or a bond: see pull.comp. The includer declares
// `uniforms`, positionOf(v), displacementOf(v) and setDisplacement(v, d).
// What a force adds to it in a sweep; the sweeps of plain PBD share it.
vec3 forceWay(PullRecord pull) {
    return uniforms.substep * uniforms.substep / float(uniforms.sweeps) *
           vec3(pull.motion_x, pull.motion_y, pull.motion_z);
}

vec3 pulled(vec3 d, vec4 x, PullRecord pull) {
    vec3 away = (x.xyz - vec3(pull.target_x, pull.target_y, pull.target_z)) + d;
    vec3 slip = d - uniforms.substep * vec3(pull.motion_x, pull.motion_y, pull.motion_z);
    float r = kPullRate * uniforms.substep;
    vec3 change = (r * r * away + 2.0 * r * slip) / (1.0 + 2.0 * r + r * r);
    if (pull.leads == kForcePull) change = -forceWay(pull);
    return x.w > 0.0 ? d - (pull.leads == 1u ? slip : change) : d;
}

// Of a bond between the facing walls of a tear: its force falls linearly from the largest as it
// opens; from less than the widest opening it goes back on a straight line. An implicit spring.
void pullByBond(PullRecord pull) {
    uint other = pull.leads - kFirstBond;
    vec4 x = positionOf(pull.vertex);
    vec4 y = positionOf(other);
    vec3 d = displacementOf(pull.vertex).xyz;
    vec3 facing = displacementOf(other).xyz;
    vec3 gap = (y.xyz - x.xyz) + (facing - d);
    float widest = max(pull.motion_z, length(gap));
    vec2 w = uniforms.inverse_density * vec2(x.w, y.w);
    float stiffness = pull.motion_x * max(1.0 / widest - 1.0 / pull.motion_y, 0.0);
    float h2 = uniforms.substep * uniforms.substep;
    vec3 way = (stiffness * h2 / (1.0 + stiffness * h2 * (w.x + w.y))) * gap;
    setDisplacement(pull.vertex, vec4(d + w.x * way, 0.0));
    setDisplacement(other, vec4(facing - w.y * way, 0.0));
}

void pullBy(PullRecord pull) {
    if (pull.leads >= kFirstBond) {
        pullByBond(pull);
    } else {
        vec3 d = displacementOf(pull.vertex).xyz;
        setDisplacement(pull.vertex, vec4(pulled(d, positionOf(pull.vertex), pull), 0.0));
    }
}
