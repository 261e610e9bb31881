// Brings each closed piece back to its target volume, as a rigid constraint (alpha = 0).
// Reads X (inverse mass), gradients, links, pieces, block sums. Reads and writes d.
// One thread per vertex: each adds up the few block sums of its piece in order.
// A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kDisplacementBinding) uniform samplerBuffer before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement { vec4 displacement[]; };
layout(binding = kLinksBinding) uniform usamplerBuffer links;
layout(binding = kGradientsBinding) uniform samplerBuffer gradients;
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlockSumsBinding) readonly buffer Sums { VolumeSum sums[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uint own = fetch(links, v).w;
    if (own == kNoPiece) return;
    PieceRecord piece = pieces[own];
    if (piece.constrained == 0u) return;
    float volume = 0.0;
    float denominator = 0.0;
    for (uint k = 0u; k < piece.block_count; ++k) {
        volume += sums[piece.first_block + k].volume;
        denominator += sums[piece.first_block + k].denominator;
    }
    if (!(denominator > 0.0)) return;
    float impulse = -(volume - piece.target_volume) / denominator;
    float w = uniforms.inverse_density * fetch(positions, v).w;
    displacement[v] = vec4(fetch(before, v).xyz + (w * impulse) * fetch(gradients, v).xyz, 0.0);
}
