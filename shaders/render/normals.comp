// Two normals per vertex: over its skin triangles and over its wall triangles, so that the edge of
// a wound stays crisp. Weighted by corner angle, so that subdividing a flat face doesn't change them;
// slivers count less, because a little motion turns them over.
// Reads positions, triangles, incidence; writes normals. One thread per vertex; a storage barrier
// follows. The gather runs in the order of the incidence list: the same bits every time.
#include "render_bindings.h"
layout(local_size_x = kNormalsGroupSize) in;

#include "body.glsl"
layout(std430, binding = kBindIncidenceRanges) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = kBindIncidence) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kBindNormals) writeonly buffer Normals { vec4 normals[]; };

// Triangles whose height is a smaller share of their longest edge are slivers.
const float kSliverQuality = 0.2;

uniform uint vertexCount;

vec3 weightedNormal(uvec4 triangle, uint corner) {
    vec3 p = positions[triangle[corner]].xyz;
    vec3 u = positions[triangle[(corner + 1u) % 3u]].xyz - p;
    vec3 v = positions[triangle[(corner + 2u) % 3u]].xyz - p;
    vec3 n = cross(u, v);
    float twiceArea = length(n);
    if (!(twiceArea > 1e-20)) {
        return vec3(0);
    }
    float longest = max(dot(u, u), max(dot(v, v), dot(u - v, u - v)));
    float shape = min(1.0, twiceArea / (kSliverQuality * longest));
    return n * (shape * atan(twiceArea, dot(u, v)) / twiceArea);
}

vec4 unit(vec3 n) {
    float size = length(n);
    return vec4(size > 0.0 ? n / size : vec3(0, 1, 0), 0);
}

void main() {
    uint vertex = gl_GlobalInvocationID.x;
    if (vertex >= vertexCount) {
        return;
    }
    vec3 skin = vec3(0);
    vec3 wall = vec3(0);
    for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
        uvec4 triangle = triangles[entries[i] / 4u];
        vec3 n = weightedNormal(triangle, entries[i] % 4u);
        if ((triangle.w & 1u) == 0u) {
            skin += n;
        } else {
            wall += n;
        }
    }
    normals[2u * vertex] = unit(skin);
    normals[2u * vertex + 1u] = unit(wall);
}
