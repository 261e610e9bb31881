// An ISPC: r = p_v - (b0 p_0 + b1 p_1 + b2 p_2), C = |r| - L0.
IspcConstraint ispcOf(uvec4 corners, uvec4 words) {
    vec4 rest = uintBitsToFloat(words);
    return IspcConstraint(corners.x, corners.y, corners.z, corners.w,
                          rest.x, rest.y, rest.z, rest.w);
}
#define fetchIspc(records, index) \
    ispcOf(fetch(records, 2u * (index)), fetch(records, 2u * (index) + 1u))

// On its vertex; the corners of the triangle that its ray ends on answer by their weights.
vec3 ispcPull(IspcConstraint ispc) {
    vec3 b = vec3(1.0 - ispc.b1 - ispc.b2, ispc.b1, ispc.b2);
    vec3 xv = positionOf(ispc.vertex).xyz;
    vec3 x0 = positionOf(ispc.t0).xyz;
    vec3 x1 = positionOf(ispc.t1).xyz;
    vec3 x2 = positionOf(ispc.t2).xyz;
    vec4 dv = displacementOf(ispc.vertex);
    vec4 d0 = displacementOf(ispc.t0);
    vec4 d1 = displacementOf(ispc.t1);
    vec4 d2 = displacementOf(ispc.t2);
    vec3 base = b.x * (xv - x0) + b.y * (xv - x1) + b.z * (xv - x2);
    vec3 step = b.x * (dv.xyz - d0.xyz) + b.y * (dv.xyz - d1.xyz) + b.z * (dv.xyz - d2.xyz);
    vec3 r = base + step;
    float reach = length(r);

    float weight = uniforms.inverse_density * dot(vec4(dv.w, d0.w, d1.w, d2.w), vec4(1.0, b * b));
    bool answers = weight > 0.0 && reach > 1e-12;
    float impulse = uniforms.share[kIspc] * (ispc.rest_length - reach) / weight;
    return answers ? r * (inversesqrt(dot(r, r)) * impulse) : vec3(0.0);
}

void solveIspc(IspcConstraint ispc, uint index) {
    setCorrection(index, vec4(ispcPull(ispc), 0.0));
}

float energyOfIspc(IspcConstraint ispc) {
    vec3 b = vec3(1.0 - ispc.b1 - ispc.b2, ispc.b1, ispc.b2);
    vec4 x = positionOf(ispc.vertex);
    vec4 x0 = positionOf(ispc.t0);
    vec4 x1 = positionOf(ispc.t1);
    vec4 x2 = positionOf(ispc.t2);
    vec3 span = b.x * (x - x0).xyz + b.y * (x - x1).xyz + b.z * (x - x2).xyz;
    float error = length(span) - ispc.rest_length;
    float moved = x.w + dot(b * b, vec3(x0.w, x1.w, x2.w));
    return energyOf(error * error, ispc.geometry, kIspc, moved);
}
