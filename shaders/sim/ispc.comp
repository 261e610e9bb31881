// Solves each internal shape-preserving constraint once against the displacement as it stands
// (XPBD, mass split among the ISPCs of a vertex): r = p_v - (b0 p_0 + b1 p_1 + b2 p_2),
// C = |r| - L0.
// Reads X, d, ISPCs. Writes the pull of each ISPC, which gather_corrections shares out. One thread
// per ISPC. A storage barrier follows, then gather_corrections.
#include "bindings.h"
#include "body_records.h"
#include "constraints.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"

STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) displacement;
RECORD_QUADS(kConstraintsBinding) ispcs;
layout(std430, binding = kCorrectionsBinding) writeonly buffer Corrections { vec4 corrections[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return fetch(displacement, v); }

#include "sim/ispc.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.ispc_count) return;
    corrections[index].xyz = ispcPull(fetchIspc(ispcs, index));
}
