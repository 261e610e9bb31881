// Solves each constraint of one type (constraints.h) once against the displacement as it stands:
// TYPE is its number, FETCH takes it from the list, and SOLVE is its function (plain PBD, mass
// split among the constraints of the type at a vertex).
// Reads X, d, records. Writes the pulls of each constraint, which gather_corrections shares out
// among its vertices. One thread per constraint. A storage barrier follows, then
// gather_corrections.
#include "constraints.h"
#include "sim/base/fetch.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) displacement;
RECORD_QUADS(kConstraintsBinding) records;
layout(std430, binding = kCorrectionsBinding) writeonly buffer Corrections { vec4 corrections[]; };

vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return fetch(displacement, v); }
void setCorrection(uint index, vec4 pull) { corrections[index] = pull; }

#include "sim/constraints.glsl"

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uniforms.count[TYPE]) return;
    SOLVE(FETCH(records, index), index);
}
