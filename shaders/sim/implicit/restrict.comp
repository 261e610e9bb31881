// Adds up the residual by the modes of each region from those of its aggregates (patches.comp).
// One group for each region. A storage barrier follows.
layout(local_size_x = GROUP) in;
#include "sim/implicit/uniforms.glsl"
#include "sim/unfold/best_rotation.glsl"
STATE_TEXELS(kModesBinding) modes;
STATE_TEXELS(kTurnsUnit) turns;
RECORD_QUADS(kRegionsUnit) regions;
layout(std430, binding = kModesBinding) writeonly buffer Modes { vec4 newModes[]; };
#include "sim/implicit/levels.glsl"

shared vec3 sums[4];

void main() {
    uint region = gl_WorkGroupID.x;
    uvec4 range = fetch(regions, 2u * region);  // ImplicitRegion
    vec4 turn = turnOfRegion(region);
    for (uint m = gl_LocalInvocationID.x; m < 4u; m += GROUP) {
        vec3 sum = vec3(0.0);
        for (uint a = range.x; a < range.y; ++a) {
            vec2 level = levelOf(a, m);
            vec3 residual = level.x * modeAt(3u * a, 0u) + level.y * modeAt(3u * a, m);
            sum += turnedBack(turn, rotated(turnOfAggregate(a), residual));
        }
        sums[m] = sum;
    }
    barrier();
    for (uint axis = gl_LocalInvocationID.x; axis < 3u; axis += GROUP) {
        newModes[residualOfRegion(region) + axis] =
            vec4(sums[0][axis], sums[1][axis], sums[2][axis], sums[3][axis]);
    }
}
