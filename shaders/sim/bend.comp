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

#include "sim/bend_angle.glsl"
#include "sim/pull_direction.glsl"

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
    Wings before = wingsOf(x1.xyz - x0.xyz, x2.xyz - x0.xyz, x3.xyz - x0.xyz);
    Wings now = wingsOf((x1.xyz - x0.xyz) + (d1 - d0), (x2.xyz - x0.xyz) + (d2 - d0),
                        (x3.xyz - x0.xyz) + (d3 - d0));
    if (degenerate(now)) {
        corrections[2u * index] = vec4(0.0);
        corrections[2u * index + 1u] = vec4(0.0);
        return;
    }
    float error = clamp(wrapped(angleOf(now) - bend.rest_angle), -kMaxBendError, kMaxBendError);

    bool little = pullsAsBefore() && turnedLittle(before.edge, now.edge) && turnedLittle(before.nA, now.nA) &&
                  turnedLittle(before.nB, now.nB);
    Wings pulled = now;
    if (little && !degenerate(before)) {
        pulled = before;
    }
    float e2 = dot(pulled.edge, pulled.edge);
    float reach = sqrt(e2);
    vec3 a = pulled.nA * (reach / dot(pulled.nA, pulled.nA));
    vec3 b = pulled.nB * (reach / dot(pulled.nB, pulled.nB));
    float sA = dot(pulled.left, pulled.edge) / e2;
    float sB = dot(pulled.right, pulled.edge) / e2;
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
