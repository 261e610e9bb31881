// The box of each triangle and its bucket in the grid, and how many triangles a bucket gets.
// Reads X, triangles. Writes boxes, homes, counts, the levels in use and how large their boxes
// are. One thread per triangle. A storage barrier follows, then scan.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactBoxesBinding) writeonly buffer Boxes { ContactBox boxes[]; };
layout(std430, binding = kContactHomesBinding) writeonly buffer Homes { uint homes[]; };
layout(std430, binding = kContactCountsBinding) buffer Counts { uint counts[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

#include "directions.glsl"
#include "grid.glsl"

void main() {
    uint t = gl_GlobalInvocationID.x;
    if (t >= uniforms.triangle_count) return;
    vec3 a = positions[triangles[t].x].xyz;
    vec3 b = positions[triangles[t].y].xyz;
    vec3 c = positions[triangles[t].z].xyz;
    vec3 low = min(a, min(b, c));
    vec3 high = max(a, max(b, c));
    vec3 extent = high - low;
    float longest = max(extent.x, max(extent.y, extent.z));
    uint level = levelOf(longest);
    uint bucket = bucketOf(ivec3(floor(0.5 * (low + high) / cellSize(level))), level);
    vec3 normal = cross(b - a, c - a);
    uint bin = dot(normal, normal) > 0.0 ? binOf(normal) : kNoBin;
    uint piece = triangles[t].w >> 8;
    boxes[t] = ContactBox(vec4(low, uintBitsToFloat(kFirstBin + bin)),
                          vec4(high, uintBitsToFloat(kFirstBin + piece)));
    homes[t] = bucket;
    atomicAdd(counts[bucket], 1u);
    atomicOr(state.levels, 1u << level);
    if (longest <= cellSize(level)) {  // all that are finite
        atomicMax(state.largest[level], floatBitsToUint(longest));
    }
}
