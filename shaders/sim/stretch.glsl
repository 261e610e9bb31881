// Prediction and edges of a vertex: see stretch.comp. The includer declares `uniforms`,
// positionOf(v), startOf(v, inverse unit mass) [m] and spokeAt(place).
vec3 predicted(vec3 speed, float inverseUnitMass) {
    if (inverseUnitMass > 0.0) {
        speed += uniforms.substep * uniforms.gravity.xyz;
    }
    return uniforms.substep * speed;
}

vec3 startOf(uint v, float inverseUnitMass);

// What a spoke adds to the displacement of its vertex, which has `count` of them.
vec3 spokePull(Spoke spoke, vec4 own, float count, vec3 ownStart) {
    vec4 far = positionOf(spoke.other);
    // The same whether starts are read or predicted here, of which a factor could be drawn out.
    precise vec3 step = ownStart - startOf(spoke.other, far.w);
    vec3 span = own.xyz - far.xyz + step;
    float reach = length(span);
    float inverseMasses =
        uniforms.inverse_density * (count * own.w + float(spoke.other_count) * far.w);
    vec3 direction = span * inversesqrt(dot(span, span));
    float impulse = (spoke.rest_length - reach) / inverseMasses;
    vec3 pull = direction * (uniforms.share[kStretch] * uniforms.inverse_density * own.w * impulse);
    return reach >= 1e-12 && inverseMasses > 0.0 ? pull : vec3(0.0);
}

// d of a vertex after its edges, of which the spokes lie at `range`.
vec3 stretched(uint v, vec4 own, uvec2 range) {
    vec3 start = startOf(v, own.w);
    vec3 sum = vec3(0.0);
    if ((uniforms.active_parts & kStretchPart) != 0u && own.w > 0.0) {
        for (uint k = range.x; k < range.y; ++k) {
            sum += spokePull(spokeAt(k), own, float(range.y - range.x), start);
        }
    }
    return start + sum;
}
