// What the CPU wants to know after a step: volume, box and whether all numbers are finite, per
// block. Reads X, velocities, triangles, pieces, blocks. Writes block measures.
// One group per block; sums in a fixed order. The CPU reads the result.
#include "bindings.h"
#include "body_records.h"
layout(local_size_x = kGroupSize) in;

layout(std430, binding = kPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) readonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = kTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kBlockSumsBinding) writeonly buffer Measures { BlockMeasure measures[]; };

shared vec4 lows[kGroupSize];
shared vec4 highs[kGroupSize];

// By bits, since compilers are free to turn a comparison round where NaN would answer differently.
bool sane(vec3 a) {
    uvec3 magnitude = floatBitsToUint(a) & 0x7fffffffu;
    uint limit = floatBitsToUint(1e10);
    return all(lessThan(magnitude, uvec3(limit)));
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    vec3 origin = positions[triangles[pieces[block.piece].first_triangle].x].xyz;
    vec4 low = vec4(vec3(1e30), 0.0);
    vec4 high = vec4(vec3(-1e30), 0.0);
    for (uint i = gl_LocalInvocationID.x; i < block.triangle_count; i += kGroupSize) {
        uvec4 t = triangles[block.first_triangle + i];
        vec3 a = positions[t.x].xyz;
        vec3 b = positions[t.y].xyz;
        vec3 c = positions[t.z].xyz;
        low.xyz = min(low.xyz, min(a, min(b, c)));
        high.xyz = max(high.xyz, max(a, max(b, c)));
        low.w += dot(a - origin, cross(b - origin, c - origin)) / 6.0;
        bool finite = sane(a) && sane(b) && sane(c) && sane(velocities[t.x].xyz) &&
            sane(velocities[t.y].xyz) && sane(velocities[t.z].xyz);
        high.w = finite ? high.w : 1.0;
    }
    uint self = gl_LocalInvocationID.x;
    lows[self] = low;
    highs[self] = high;
    for (uint span = kGroupSize / 2u; span > 0u; span /= 2u) {
        barrier();
        if (self < span) {
            vec4 otherLow = lows[self + span];
            vec4 otherHigh = highs[self + span];
            lows[self] = vec4(min(lows[self].xyz, otherLow.xyz), lows[self].w + otherLow.w);
            highs[self] = max(highs[self], otherHigh);
        }
    }
    if (self == 0u) {
        measures[gl_WorkGroupID.x] = BlockMeasure(lows[0], highs[0]);
    }
}
