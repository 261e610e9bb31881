// Prediction and edges of a vertex: see stretch.comp. The includer declares `uniforms`,
// positionOf(v), startOf(v, inverse unit mass) [m] and spokeAt(place).
#include "sim/folds.glsl"
#include "sim/pull_direction.glsl"

vec3 predicted(vec3 speed, float inverseUnitMass) {
    if (inverseUnitMass > 0.0) {
        speed += uniforms.substep * uniforms.gravity.xyz;
    }
    return uniforms.substep * speed;
}

vec3 startOf(uint v, float inverseUnitMass);

// What a spoke adds to the displacement of its vertex, which has `count` of them.
vec3 spokePull(Spoke spoke, vec4 own, float count, vec3 ownStart, float ownFold) {
    vec4 far = positionOf(spoke.other);
    vec3 step = ownStart - startOf(spoke.other, far.w);
    vec3 before = own.xyz - far.xyz;
    vec3 span = before + step;
    float reach = length(span);
    float inverseMasses =
        uniforms.inverse_density * (count * own.w + float(spoke.other_count) * far.w);
    float fold = max(ownFold, foldAt(spoke.other));
    float compliance = spoke.geometry * uniforms.compliance[kStretch];
    float gamma = dampingOf(inverseMasses, compliance, fold, kStretch);
    float denominator = dampedWeight(inverseMasses, compliance, gamma, kStretch);
    vec3 direction = pullDirection(before, span);
    float impulse =
        -dampedError(reach - spoke.rest_length, dot(direction, step), gamma, fold, 1.0) /
        denominator;
    vec3 pull = direction * (uniforms.share[kStretch] * uniforms.inverse_density * own.w * impulse);
    return reach >= 1e-12 && denominator > 0.0 ? pull : vec3(0.0);
}

// d of a vertex after its edges, of which the spokes lie at `range`.
vec3 stretched(uint v, vec4 own, uvec2 range) {
    vec3 start = startOf(v, own.w);
    float fold = foldAt(v);
    vec3 sum = vec3(0.0);
    if ((uniforms.active_parts & kStretchPart) != 0u && own.w > 0.0) {
        for (uint k = range.x; k < range.y; ++k) {
            sum += spokePull(spokeAt(k), own, float(range.y - range.x), start, fold);
        }
    }
    return start + sum;
}
