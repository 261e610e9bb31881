// Adds to each vertex the corrections of its bends, or of its ISPCs, in the fixed order of the
// incidence. Reads corrections and incidence. Reads and writes d.
// One thread per vertex. A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(std430, binding = kDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kRangesBinding) readonly buffer Ranges { IncidenceRange ranges[]; };
layout(std430, binding = kEntriesBinding) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kCorrectionsBinding) readonly buffer Corrections { vec4 corrections[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec3 sum = vec3(0.0);
    for (uint k = ranges[v].first; k < ranges[v].end; ++k) {
        sum += corrections[entries[k]].xyz;
    }
    displacement[v] = vec4(displacement[v].xyz + sum, 0.0);
}
