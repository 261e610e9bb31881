// d of a vertex that a hand pulls: see pull.comp. The includer declares `uniforms`.
vec3 pulled(vec3 d, vec4 x, PullRecord pull) {
    vec3 away = (x.xyz - vec3(pull.target_x, pull.target_y, pull.target_z)) + d;
    vec3 slip = d - uniforms.substep * vec3(pull.motion_x, pull.motion_y, pull.motion_z);
    float r = kPullRate * uniforms.substep;
    vec3 change = (r * r * away + 2.0 * r * slip) / (1.0 + 2.0 * r + r * r);
    return x.w > 0.0 ? d - (pull.leads != 0u ? slip : change) : d;
}
