// The end of a substep in which nothing but the floor is met: volume_correct, floor and finish of a
// vertex in one go. Reads gradients, links, impulses, d. Reads and writes X and velocities, with
// UNFOLDS folds; d stays as it was. One thread per vertex. A storage barrier follows.
#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) before;
layout(std430, binding = kPositionsBinding) writeonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
STATE_TEXELS(kDisplacementBinding) displacement;
RECORD_QUADS(kLinksBinding) links;
STATE_TEXELS(kGradientsBinding) gradients;
layout(std430, binding = kImpulsesBinding) readonly buffer Impulses { VolumeImpulse impulses[]; };

vec3 gradientOf(uint v) { return fetch(gradients, v).xyz; }
float impulseFor(uint piece) { return impulses[piece].impulse; }
uint pieceOf(uint v) { return fetch(links, v).w; }

#include "sim/settle.glsl"

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    vec4 x = fetch(before, v);
    vec3 d = fetch(displacement, v).xyz;
    if ((uniforms.active_parts & kVolumePart) != 0u) d = heldByVolume(v, d, x.w);
    if ((uniforms.active_parts & kFloorPart) != 0u) d = onFloor(d, x, foldAt(v));
    endFold(v);
    if (x.w > 0.0) {
        velocities[v].xyz = endVelocity(d);
    }
    positions[v].xyz = x.xyz + d;
}
