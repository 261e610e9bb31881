// How each region moves, by its modes: as the inverse at rest says of the residuals of all regions
// of its piece (restrict.comp). One group for each region. A storage barrier follows.
layout(local_size_x = GROUP) in;
#include "sim/implicit/uniforms.glsl"
RECORD_QUADS(kRegionsUnit) regions;
layout(std430, binding = kModesBinding) writeonly buffer Modes { vec4 newModes[]; };
#include "sim/implicit/coarse_rows.glsl"

void main() {
    uvec4 own = fetch(regions, 2u * gl_WorkGroupID.x + 1u);  // ImplicitRegion, second half
    findModes(uvec2(implicit.aggregate_count + own.x, own.y), own.z);
    uint first = 3u * (implicit.aggregate_count + implicit.region_count + gl_WorkGroupID.x);
    for (uint axis = gl_LocalInvocationID.x; axis < 3u; axis += GROUP) {
        newModes[first + axis] = modesOf(axis);
    }
}
