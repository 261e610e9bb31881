// Adds to each vertex what its bends pull (GATHER_BENDS) or its ISPCs (GATHER_ISPCS).
// With ONTO_FLOOR it lifts the vertex onto the floor besides, as floor.comp does.
// Reads X, corrections, links, lists. Reads and writes d.
// One thread per vertex. A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"

STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};
RECORD_QUADS(kLinksBinding) links;
#ifdef GATHER_BENDS
RECORD_QUADS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) entries;
#else
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_QUADS(kEntriesBinding) entries;
#endif
STATE_TEXELS(kCorrectionsBinding) corrections;

vec4 correctionAt(uint index) { return fetch(corrections, index); }
#ifdef GATHER_BENDS
uvec2 bendEntriesAt(uint pair) { return fetch(entries, pair).xy; }
#else
IspcSharePair ispcSharesAt(uint pair) { return fetchIspcShares(entries, pair); }
#endif

#include "sim/gather.glsl"
#include "sim/mass_split.glsl"
#ifdef ONTO_FLOOR
#include "sim/floor.glsl"
#endif

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
#ifdef GATHER_BENDS
    vec3 sum = bendSum(fetchBendRange(ranges, v));
#else
    vec3 sum = ispcSum(fetch(ranges, v).xy);
#endif
    vec4 x = fetch(positions, v);
    vec3 d = withSum(fetch(before, v).xyz, x.w, sum);
#ifdef ONTO_FLOOR
    d = onFloor(d, x, foldAt(v));
#endif
    displacement[v] = vec4(d, secondSplit(x.w, fetch(links, v)));
}
