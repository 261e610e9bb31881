// The box around each piece of the body: the first part of the broad phase of the paper's contact.
// Reads X, triangles. Writes boxes of pieces, which begin empty. One thread per triangle; a minimum
// does not mind the order in which threads come. A storage barrier follows.
#include "box_records.h"
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kPaperPiecesBinding) coherent buffer Bounds { PieceBounds bounds[]; };

#include "sim/base/ordered_floats.glsl"

// Most triangles lie inside of what is known already.
void main() {
    uint t = gl_GlobalInvocationID.x;
    if (t >= uniforms.triangle_count) return;
    uint p = triangles[t].w >> 8;
    vec3 a = positions[triangles[t].x].xyz;
    vec3 b = positions[triangles[t].y].xyz;
    vec3 c = positions[triangles[t].z].xyz;
    vec3 low = min(a, min(b, c));
    vec3 high = max(a, max(b, c));
    uvec3 lowest = uvec3(orderedWord(low.x), orderedWord(low.y), orderedWord(low.z));
    uvec3 highest = uvec3(orderedWord(high.x), orderedWord(high.y), orderedWord(high.z));
    if (lowest.x < bounds[p].low_x) atomicMin(bounds[p].low_x, lowest.x);
    if (lowest.y < bounds[p].low_y) atomicMin(bounds[p].low_y, lowest.y);
    if (lowest.z < bounds[p].low_z) atomicMin(bounds[p].low_z, lowest.z);
    if (highest.x > bounds[p].high_x) atomicMax(bounds[p].high_x, highest.x);
    if (highest.y > bounds[p].high_y) atomicMax(bounds[p].high_y, highest.y);
    if (highest.z > bounds[p].high_z) atomicMax(bounds[p].high_z, highest.z);
}
