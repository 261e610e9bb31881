// Predicts the displacement of the step, d = h (v + h g), and solves the edges against it: one
// mass-splitting Jacobi sweep of plain PBD.
// Reads X, velocities, links and the spokes of each vertex. Writes d.
// One thread per vertex: it works each incident edge out anew, in the fixed order of the incidence,
// and predicts its neighbours from their velocities, so that no second buffer is needed.
// With SWEEP_AGAIN it starts from a copy of d instead: the later sweeps.
// A storage barrier follows.
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};
RECORD_QUADS(kLinksBinding) links;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_QUADS(kEntriesBinding) spokes;

#include "sim/mass_split.glsl"

// d before the edges [m].
#ifdef SWEEP_AGAIN
STATE_TEXELS(kPreviousBinding) previous;

vec3 startOf(uint v, float inverseUnitMass) { return fetch(previous, v).xyz; }
#else
vec3 startOf(uint v, float inverseUnitMass) {
    vec3 speed = fetch(velocities, v).xyz;
    if (inverseUnitMass > 0.0) {
        speed += uniforms.substep * uniforms.gravity.xyz;
    }
    return uniforms.substep * speed;
}
#endif

// What a spoke adds to the displacement of its vertex, which has `count` of them.
vec3 spokePull(Spoke spoke, vec4 own, float count, vec3 ownStart) {
    vec4 far = fetch(positions, spoke.other);
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
            sum += spokePull(fetchSpoke(spokes, k), own, float(range.y - range.x), start);
        }
    }
    return start + sum;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 own = fetch(positions, v);
    displacement[v] = vec4(stretched(v, own, fetch(ranges, v).xy),
                           splitFrom(kStretch + 1u, own.w, fetch(links, v)));
}
