// d of a vertex that a hand pulls, or a force: see pull.comp. The includer declares `uniforms`.
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
