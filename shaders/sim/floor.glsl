// d of a vertex that the floor has lifted: see floor.comp. x: X and inverse unit mass. The includer
// declares `uniforms`.
vec3 onFloor(vec3 d, vec4 x) {
    float lowest = min(uniforms.floor_height - x.y, uniforms.lift_speed * uniforms.substep);
    float lift = lowest - d.y;
    bool lifted = lift > 0.0 && x.w != 0.0;
    float slip = length(d.xz);
    float kept = slip > 0.0 ? 1.0 - min(1.0, uniforms.friction * lift / slip) : 1.0;
    return lifted ? vec3(d.x * kept, d.y + lift, d.z * kept) : d;
}
