// Brings each closed piece back to its target volume: see volume_gradient.
// Reads X (inverse mass), gradients, links, impulses. Reads and writes d.
// One thread per vertex. A storage barrier follows.
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kDisplacementBinding) before;
layout(std430, binding = kDisplacementBinding) writeonly buffer Displacement {
    vec4 displacement[];
};
RECORD_QUADS(kLinksBinding) links;
STATE_TEXELS(kGradientsBinding) gradients;
layout(std430, binding = kImpulsesBinding) readonly buffer Impulses { VolumeImpulse impulses[]; };

#include "sim/volume_correct.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    uint piece = fetch(links, v).w;
    if (piece == kNoPiece) return;
    displacement[v] = vec4(withVolume(fetch(before, v).xyz, fetch(positions, v).w,
                                      impulses[piece].impulse, fetch(gradients, v).xyz), 0.0);
}
