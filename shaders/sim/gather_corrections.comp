// Adds to each vertex what the constraints of one type pull it with: TYPE is its number, RANGES and
// ENTRIES declare its lists, SUM sums them up.
// Reads X, corrections, links, lists. Reads and writes d.
// One thread per vertex. A storage barrier follows.
#include "constraints.h"
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};
RECORD_QUADS(kLinksBinding) links;
RANGES(kRangesBinding) ranges;
ENTRIES(kEntriesBinding) entries;
STATE_TEXELS(kCorrectionsBinding) corrections;

vec4 correctionAt(uint index) { return fetch(corrections, index); }
uvec4 rangeOfList(uint type, uint v) { return fetch(ranges, v); }
uvec4 entryOfList(uint type, uint index) { return fetch(entries, index); }

#include "sim/gather.glsl"
#include "sim/mass_split.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec3 sum = SUM(TYPE, v);
    vec4 x = fetch(positions, v);
    vec3 d = withSum(fetch(before, v).xyz, x.w, sum);
    displacement[v] = vec4(d, splitFrom(TYPE + 1u, x.w, fetch(links, v)));
}
