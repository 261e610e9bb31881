// What the CPU wants to know after a step: volume, boxes of positions and velocities and whether a
// vertex is lost (not finite, or faster than anything real), per block; behind the blocks, how many
// contacts there were. Reads X, velocities, neighbours, places, pages, pieces, blocks, the state of
// contact. Writes block measures. One group per block; sums in a fixed order (see volume_gradient).
// The CPU reads the result.
#include "bindings.h"
#include "body_records.h"
#include "contact_records.h"
#include "solver_uniforms.h"
layout(local_size_x = kGroupSize) in;

#include "sim/fetch.glsl"

layout(std430, binding = kUniformsBinding) readonly buffer Uniforms { SolverUniforms uniforms; };
layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kVelocitiesBinding) uniform samplerBuffer velocities;
layout(binding = kRangesBinding) uniform usamplerBuffer ranges;
layout(binding = kEntriesBinding) uniform usamplerBuffer neighbours;
layout(binding = kPlacesBinding) uniform usamplerBuffer places;
layout(std430, binding = kPagesBinding) readonly buffer Pages { uint pages[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kContactCountsOfStepBinding) readonly buffer Contacts { ContactState contacts; };
layout(std430, binding = kBlockSumsBinding) writeonly buffer Measures { BlockMeasure measures[]; };

shared vec4 lows[kGroupSize];
shared vec4 highs[kGroupSize];
shared vec3 slowest[kGroupSize];
shared vec3 fastest[kGroupSize];

vec3 span(uint from, uint to) {
    return fetch(positions, to).xyz - fetch(positions, from).xyz;
}

#include "sim/volume_gradient.glsl"

// By bits, since compilers are free to turn a comparison round where NaN would answer differently.
bool within(vec3 a, float limit) {
    uvec3 magnitude = floatBitsToUint(a) & 0x7fffffffu;
    return all(lessThan(magnitude, uvec3(floatBitsToUint(limit))));
}

bool lost(vec3 position, vec3 velocity) {
    return !within(position, 1e10) || !within(velocity, uniforms.runaway_speed);
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    uint origin = pieces[block.piece].origin;
    uint self = gl_LocalInvocationID.x;
    vec4 low = vec4(vec3(1e30), 0.0);
    vec4 high = vec4(vec3(-1e30), 0.0);
    vec3 slow = vec3(1e30);
    vec3 fast = vec3(-1e30);
    for (uint i = 0u; i < block.page_count; ++i) {
        uint v = fetch(places, kPageSize * pages[block.first_page + i] + self).x;
        if (v == kNoVertex) continue;
        vec3 p = fetch(positions, v).xyz;
        low = vec4(min(low.xyz, p), low.w + dot(span(origin, v), volumeGradient(v)) / 3.0);
        vec3 u = fetch(velocities, v).xyz;
        high = vec4(max(high.xyz, p), lost(p, u) ? 1.0 : high.w);
        slow = min(slow, u);
        fast = max(fast, u);
    }
    lows[self] = low;
    highs[self] = high;
    slowest[self] = slow;
    fastest[self] = fast;
    for (uint reach = kGroupSize / 2u; reach > 0u; reach /= 2u) {
        barrier();
        if (self < reach) {
            vec4 other = lows[self + reach];
            lows[self] = vec4(min(lows[self].xyz, other.xyz), lows[self].w + other.w);
            highs[self] = max(highs[self], highs[self + reach]);
            slowest[self] = min(slowest[self], slowest[self + reach]);
            fastest[self] = max(fastest[self], fastest[self + reach]);
        }
    }
    if (self == 0u && gl_WorkGroupID.x == 0u) {
        measures[gl_NumWorkGroups.x] = BlockMeasure(vec4(contacts.last_contacts), vec4(0.0),
                                                    vec4(0.0), vec4(0.0));
    }
    if (self == 0u) {
        measures[gl_WorkGroupID.x] = BlockMeasure(lows[0], highs[0], vec4(slowest[0], 0.0),
                                                  vec4(fastest[0], 0.0));
    }
}
