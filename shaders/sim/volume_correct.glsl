// d of a vertex once its piece has its volume: see volume_gradient.comp. The includer declares
// `uniforms`.
vec3 withVolume(vec3 d, float inverseUnitMass, float impulse, vec3 gradient) {
    return d + (uniforms.inverse_density * inverseUnitMass * impulse) * gradient;
}
