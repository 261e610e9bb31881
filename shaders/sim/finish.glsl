// The velocity at the end of a step: d / h exp(-c h). The includer declares `uniforms`.
vec3 endVelocity(vec3 d) {
    return d / uniforms.substep * uniforms.drag_factor;
}
