// Predicts the displacement of the step, d = h (v + h g), and solves the edges against it: one
// mass-splitting Jacobi sweep of plain PBD.
// Reads X, velocities, links and the spokes of each vertex. Writes d.
// One thread per vertex: it works each incident edge out anew, in the fixed order of the incidence,
// and predicts its neighbours from their velocities, so that no second buffer is needed.
// With SWEEP_AGAIN it starts from a copy of d instead: the later sweeps.
// A storage barrier follows.
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};
RECORD_QUADS(kLinksBinding) links;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_QUADS(kEntriesBinding) spokes;

vec4 positionOf(uint v) { return fetch(positions, v); }
Spoke spokeAt(uint place) { return fetchSpoke(spokes, place); }

#include "sim/mass_split.glsl"
#include "sim/stretch.glsl"

#ifdef SWEEP_AGAIN
STATE_TEXELS(kPreviousBinding) previous;

vec3 startOf(uint v, float inverseUnitMass) {
    return fetch(previous, v).xyz;
}
#else
vec3 startOf(uint v, float inverseUnitMass) {
    return predicted(fetch(velocities, v).xyz, inverseUnitMass);
}
#endif

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 own = positionOf(v);
    displacement[v] = vec4(stretched(v, own, fetch(ranges, v).xy),
                           splitFrom(kStretch + 1u, own.w, fetch(links, v)));
}
