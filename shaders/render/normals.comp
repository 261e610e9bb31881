// Two normals per vertex: over its skin triangles and over its wall triangles, so that the edge of
// a wound stays crisp. A vertex that a cut made or divided has the normal that the whole skin had
// there at rest, turned as the triangles around it have turned, so that a closed cut does not show.
// Weighted by corner angle, so that subdividing a flat face doesn't change them; slivers count
// less, because a little motion turns them over. Reads positions, rest positions, normals of cut
// skin, triangles, incidence; writes normals. One thread per vertex; a storage barrier follows. The
// gather runs in the order of the incidence list: the same bits every time.
#include "render_bindings.h"
layout(local_size_x = kNormalsGroupSize) in;

#include "body.glsl"
layout(std430, binding = kBindRestPositions) readonly buffer RestPositions {
    vec4 restPositions[];
};
layout(std430, binding = kBindCutSkinNormals) readonly buffer CutSkinNormals {
    vec4 cutSkinNormals[];
};
layout(std430, binding = kBindIncidenceRanges) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = kBindIncidence) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kBindNormals) writeonly buffer Normals { vec4 normals[]; };

// Triangles whose height is a smaller share of their longest edge are slivers.
const float kSliverQuality = 0.2;

uniform uint vertexCount;

vec3 weightedNormal(vec3 u, vec3 v) {
    vec3 n = cross(u, v);
    float twiceArea = length(n);
    if (!(twiceArea > 1e-20)) {
        return vec3(0);
    }
    float longest = max(dot(u, u), max(dot(v, v), dot(u - v, u - v)));
    float shape = min(1.0, twiceArea / (kSliverQuality * longest));
    return n * (shape * atan(twiceArea, dot(u, v)) / twiceArea);
}

vec3 normalNow(uvec4 triangle, uint corner) {
    vec3 p = positions[triangle[corner]].xyz;
    return weightedNormal(positions[triangle[(corner + 1u) % 3u]].xyz - p,
                          positions[triangle[(corner + 2u) % 3u]].xyz - p);
}

vec3 normalAtRest(uvec4 triangle, uint corner) {
    vec3 p = restPositions[triangle[corner]].xyz;
    return weightedNormal(restPositions[triangle[(corner + 1u) % 3u]].xyz - p,
                          restPositions[triangle[(corner + 2u) % 3u]].xyz - p);
}

bool isSkin(uvec4 triangle) {
    return (triangle.w & 1u) == 0u;
}

vec3 unit(vec3 n) {
    float size = length(n);
    return size > 0.0 ? n / size : vec3(0, 1, 0);
}

// What turns the unit vector `from` into `to` by the shortest way, done to n.
vec3 turned(vec3 n, vec3 from, vec3 to) {
    vec3 axis = cross(from, to);
    float cosine = dot(from, to);
    if (cosine < -0.99) {
        return to;
    }
    return n * cosine + cross(axis, n) + axis * (dot(axis, n) / (1.0 + cosine));
}

// Of a vertex that a cut made or divided, around which the skin has the normal `now`.
vec3 wholeSkinNormal(uint vertex, vec3 now) {
    vec3 rest = vec3(0);
    for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
        uvec4 triangle = triangles[entries[i] / 4u];
        if (isSkin(triangle)) {
            rest += normalAtRest(triangle, entries[i] % 4u);
        }
    }
    return turned(cutSkinNormals[vertex].xyz, unit(rest), now);
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
        vec3 n = normalNow(triangle, entries[i] % 4u);
        if (isSkin(triangle)) {
            skin += n;
        } else {
            wall += n;
        }
    }
    vec3 outside = unit(skin);
    if (cutSkinNormals[vertex].xyz != vec3(0)) {
        outside = wholeSkinNormal(vertex, outside);
    }
    normals[2u * vertex] = vec4(outside, 0);
    normals[2u * vertex + 1u] = vec4(unit(wall), 0);
}
