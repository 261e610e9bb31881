// Solves each bend once against the displacement as it stands:
//
//            v2            e = v1 - v0, nA = e x (v2 - v0), nB = (v3 - v0) x e
//           /  |           theta = atan2((nA x nB) . e / |e|, nA . nB): flat 0, convex > 0
//         v0 -> v1
//           |  /
//            v3
//
// Reads X, d, links, bends. Writes what gather_corrections makes the four corrections of: the pull
// at v2 and v3 and where along the edge each acts on v0 and v1. One thread per bend.
// A storage barrier follows, then gather_corrections.
#include "bindings.h"
#include "body_records.h"
#include "constraints.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kDisplacementBinding) uniform samplerBuffer displacement;
layout(binding = kLinksBinding) uniform usamplerBuffer links;
layout(binding = kConstraintsBinding) uniform usamplerBuffer bends;
layout(std430, binding = kCorrectionsBinding) writeonly buffer Corrections { vec4 corrections[]; };

#include "sim/inverse_tangent.glsl"

float wrapped(float angle) {
    const float kTwoPi = 6.28318530717959;
    return angle > 0.5 * kTwoPi ? angle - kTwoPi : (angle < -0.5 * kTwoPi ? angle + kTwoPi : angle);
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.bend_count) return;
    BendConstraint bend = fetchBend(bends, index);
    vec4 x0 = fetch(positions, bend.v0);
    vec4 x1 = fetch(positions, bend.v1);
    vec4 x2 = fetch(positions, bend.v2);
    vec4 x3 = fetch(positions, bend.v3);
    vec3 d0 = fetch(displacement, bend.v0).xyz;
    vec3 d1 = fetch(displacement, bend.v1).xyz;
    vec3 d2 = fetch(displacement, bend.v2).xyz;
    vec3 d3 = fetch(displacement, bend.v3).xyz;
    vec3 e = (x1.xyz - x0.xyz) + (d1 - d0);
    vec3 left = (x2.xyz - x0.xyz) + (d2 - d0);
    vec3 right = (x3.xyz - x0.xyz) + (d3 - d0);
    vec3 nA = cross(e, left);
    vec3 nB = cross(right, e);
    float lengthA2 = dot(nA, nA);
    float lengthB2 = dot(nB, nB);
    float e2 = dot(e, e);
    if (lengthA2 <= 1e-8 * e2 * e2 || lengthB2 <= 1e-8 * e2 * e2 || !(e2 > 0.0)) {
        corrections[2u * index] = vec4(0.0);
        corrections[2u * index + 1u] = vec4(0.0);
        return;
    }
    float reach = sqrt(e2);
    float theta = inverseTangent(dot(cross(nA, nB), e) / reach, dot(nA, nB));
    float error = clamp(wrapped(theta - bend.rest_angle), -kMaxBendError, kMaxBendError);

    vec3 a = nA * (reach / lengthA2);
    vec3 b = nB * (reach / lengthB2);
    float sA = dot(left, e) / e2;
    float sB = dot(right, e) / e2;
    vec3 g0 = (1.0 - sA) * a + (1.0 - sB) * b;
    vec3 g1 = sA * a + sB * b;
    vec3 g2 = -a;
    vec3 g3 = -b;

    vec4 w = uniforms.inverse_density * vec4(x0.w, x1.w, x2.w, x3.w);
    vec4 counts = vec4(fetch(links, bend.v0).y, fetch(links, bend.v1).y, fetch(links, bend.v2).y,
                       fetch(links, bend.v3).y);
    float weight = dot(counts * w, vec4(dot(g0, g0), dot(g1, g1), dot(g2, g2), dot(g3, g3)));
    float gamma = uniforms.damping_ratio;
    float denominator = (1.0 + gamma) * weight + bend.geometry * uniforms.bend_compliance;
    float rate = dot(g0, d0) + dot(g1, d1) + dot(g2, d2) + dot(g3, d3);
    float impulse =
        weight > 0.0 ? uniforms.bend_share * -(error + gamma * rate) / denominator : 0.0;
    corrections[2u * index] = vec4(a * impulse, sA);
    corrections[2u * index + 1u] = vec4(b * impulse, sB);
}
