// How far each patch, each aggregate and each region has turned since rest. One thread each.
#include "sim/implicit/uniforms.glsl"
#include "sim/unfold/best_rotation.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kRestUnit) rest;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
RECORD_PAIRS(kPatchesUnit) patches;
RECORD_QUADS(kRegionsUnit) regions;
layout(std430, binding = kMadeTurnsBinding) writeonly buffer Turns { vec4 turns[]; };

vec4 turnOf(uvec2 range) {
    uint origin = fetch(members, range.x).x;
    vec3 center = fetch(positions, origin).xyz;
    vec3 restCenter = fetch(rest, origin).xyz;
    vec3 mean = vec3(0.0);
    vec3 restMean = vec3(0.0);
    for (uint k = range.x; k < range.y; ++k) {
        uint v = fetch(members, k).x;
        mean += fetch(positions, v).xyz - center;
        restMean += fetch(rest, v).xyz - restCenter;
    }
    float share = 1.0 / float(range.y - range.x);
    center += share * mean;
    restCenter += share * restMean;
    vec3 sx = vec3(0.0);
    vec3 sy = vec3(0.0);
    vec3 sz = vec3(0.0);
    for (uint k = range.x; k < range.y; ++k) {
        uint v = fetch(members, k).x;
        vec3 from = fetch(rest, v).xyz - restCenter;
        vec3 to = fetch(positions, v).xyz - center;
        sx += from.x * to;
        sy += from.y * to;
        sz += from.z * to;
    }
    return bestRotation(sx, sy, sz);
}

uvec2 membersOf(uint index) {
    if (index < implicit.patch_count) return fetch(patches, index).xy;
    index -= implicit.patch_count;
    if (index < implicit.aggregate_count) return fetch(aggregates, index).xy;
    return fetch(regions, 2u * (index - implicit.aggregate_count)).zw;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= implicit.patch_count + implicit.aggregate_count + implicit.region_count) return;
    turns[index] = turnOf(membersOf(index));
}
