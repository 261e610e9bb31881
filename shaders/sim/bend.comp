// Solves each bend once against the displacement as it stands:
//
//            v2            e = v1 - v0, nA = e x (v2 - v0), nB = (v3 - v0) x e
//           /  |           theta = atan2((nA x nB) . e / |e|, nA . nB): flat 0, convex > 0
//         v0 -> v1
//           |  /
//            v3
//
// Reads X, d, bends. Writes the pull of each bend, which gather_corrections shares out among its
// four vertices. One thread per bend. A storage barrier follows, then gather_corrections.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"

STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) displacement;
RECORD_QUADS(kConstraintsBinding) bends;
layout(std430, binding = kCorrectionsBinding) writeonly buffer Corrections { vec4 corrections[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return fetch(displacement, v); }

#include "sim/bend.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.bend_count) return;
    BendPull pull = bendPull(fetchBend(bends, index));
    corrections[2u * index] = pull.left;
    corrections[2u * index + 1u] = pull.right;
}
