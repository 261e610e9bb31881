// Two normals per vertex: over its skin triangles and over its wall triangles, so that the edge of
// a wound stays crisp. A vertex that a cut made or divided has the normal that the whole skin had
// there at rest, turned as the triangles around it have turned, so that a closed cut does not show.
// Weighted by corner angle, so that subdividing a flat face doesn't change them; slivers count
// less, because a little motion turns them over. Besides, a normal for each corner of the skin:
// where faces meet at more than an angle at rest, those on either side of such an edge have their
// own. And a list of the edges on the rims of cuts.
// Reads positions, rest positions, normals of cut skin, triangles, incidence; writes normals,
// corner normals, rims. One thread per vertex; a storage barrier follows. The gather runs in the
// order of the incidence list: the same bits every time. The order of the rims is another one each
// time.
#include "render_bindings.h"
layout(local_size_x = kNormalsGroupSize) in;

#include "body.glsl"
#include "corner_normals.glsl"
layout(std430, binding = kBindRestPositions) readonly buffer RestPositions {
    vec4 restPositions[];
};
layout(std430, binding = kBindCutSkinNormals) readonly buffer CutSkinNormals {
    vec4 cutSkinNormals[];
};
layout(std430, binding = kBindIncidenceRanges) readonly buffer Ranges { uvec2 ranges[]; };
layout(std430, binding = kBindIncidence) readonly buffer Entries { uint entries[]; };
layout(std430, binding = kBindNormals) writeonly buffer Normals { vec4 normals[]; };
#define SKIN_CORNERS_ACCESS
#include "skin_corners.glsl"

// Triangles whose height is a smaller share of their longest edge are slivers.
const float kSliverQuality = 0.2;

// So many triangles around a vertex are told apart by the edges between them. Of more, as about a
// corner of a coarse body that was cut, those that faced alike at rest belong together.
const int kMostFan = 20;
const int kMostSides = 4;

uniform uint vertexCount;
uniform uint triangleCount;
uniform float hardCosine;  // of the angle above which an edge of the skin is hard
uniform float hardHalfCosine;

vec3 weightedNormal(vec3 u, vec3 v) {
    vec3 n = cross(u, v);
    float twiceArea = length(n);
    if (!(twiceArea > 1e-30)) {
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
    return turned(normalize(cutSkinNormals[vertex].xyz), unit(rest), now);
}

// --- Hard edges

// Whether the skin around a vertex is bent so much that a hard edge may be there.
bool isBent(uint vertex) {
    vec3 first = vec3(0);
    bool bent = false;
    for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
        uvec4 triangle = triangles[entries[i] / 4u];
        if (isSkin(triangle)) {
            vec3 n = normalNow(triangle, entries[i] % 4u);
            first = first == vec3(0) ? n : first;
            float size = length(n) * length(first);
            bent = bent || (size > 0.0 && dot(first, n) < hardHalfCosine * size);
        }
    }
    return bent;
}

// The triangles of the skin around a vertex, and to which smooth part of it each belongs.
struct Fan {
    int count;
    uint entry[kMostFan];
    vec3 rest[kMostFan];  // unit normals at rest
    int part[kMostFan];
};
// Of this thread. No array is passed that changes: NVIDIA's compilers took such for others.
Fan fan;

void lookAround(uint vertex) {
    fan.count = 0;
    for (uint i = ranges[vertex].x; i < ranges[vertex].y && fan.count < kMostFan; ++i) {
        uvec4 triangle = triangles[entries[i] / 4u];
        if (isSkin(triangle)) {
            fan.entry[fan.count] = entries[i];
            fan.rest[fan.count] = unit(normalAtRest(triangle, entries[i] % 4u));
            fan.part[fan.count] = fan.count;
            ++fan.count;
        }
    }
}

// Whether two triangles around a vertex have an edge together that is not hard.
bool goOn(uint a, uint b, vec3 restA, vec3 restB) {
    uvec4 ta = triangles[a / 4u];
    uvec4 tb = triangles[b / 4u];
    bool together = ta[(a % 4u + 1u) % 3u] == tb[(b % 4u + 2u) % 3u] ||
        ta[(a % 4u + 2u) % 3u] == tb[(b % 4u + 1u) % 3u];
    return together && dot(restA, restB) >= hardCosine;
}

// Joins what goes on across an edge; false where nothing was left to join.
bool joinParts() {
    bool changed = false;
    for (int i = 0; i < fan.count; ++i) {
        for (int j = 0; j < i; ++j) {
            if (fan.part[i] != fan.part[j] &&
                goOn(fan.entry[i], fan.entry[j], fan.rest[i], fan.rest[j])) {
                fan.part[i] = fan.part[j] = min(fan.part[i], fan.part[j]);
                changed = true;
            }
        }
    }
    return changed;
}

// Writes a normal for each corner at a vertex, over the smooth part that it belongs to; returns
// whether there is more than one part.
bool writeParts(uint vertex) {
    lookAround(vertex);
    for (int round = 0; round < kMostFan && joinParts(); ++round) {}
    bool hard = false;
    for (int i = 0; i < fan.count; ++i) {
        vec3 sum = vec3(0);
        for (int j = 0; j < fan.count; ++j) {
            if (fan.part[j] == fan.part[i]) {
                sum += normalNow(triangles[fan.entry[j] / 4u], fan.entry[j] % 4u);
            }
        }
        hard = hard || fan.part[i] != fan.part[0];
        uint entry = fan.entry[i];
        skinCorners[3u * (entry / 4u) + entry % 4u] = packedNormal(unit(sum));
    }
    return hard;
}

// How the sides around a vertex faced at rest, of this thread.
vec3 faces[kMostSides];
int sideCount;

// The first side that faced alike at rest, or a new one.
int sideOf(vec3 face) {
    int side = 0;
    while (side < sideCount && side < kMostSides - 1 && dot(face, faces[side]) < hardCosine) {
        ++side;
    }
    if (side == sideCount) {
        faces[sideCount++] = face;
    }
    return side;
}

// As writeParts(), of any number of triangles.
bool writeSides(uint vertex) {
    vec3 sums[kMostSides] = vec3[](vec3(0), vec3(0), vec3(0), vec3(0));
    sideCount = 0;
    for (int round = 0; round < 2; ++round) {
        for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
            uvec4 triangle = triangles[entries[i] / 4u];
            uint corner = entries[i] % 4u;
            int side = isSkin(triangle) ? sideOf(unit(normalAtRest(triangle, corner))) : 0;
            if (isSkin(triangle) && round == 0) {
                sums[side] += normalNow(triangle, corner);
            } else if (isSkin(triangle)) {
                skinCorners[3u * (entries[i] / 4u) + corner] = packedNormal(unit(sums[side]));
            }
        }
    }
    return sideCount > 1;
}

void writeCorners(uint vertex, vec3 normal) {
    uint word = packedNormal(normal);
    for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
        skinCorners[3u * (entries[i] / 4u) + entries[i] % 4u] = word;
    }
}

// --- Rims

void noteRims(uint vertex) {
    for (uint i = ranges[vertex].x; i < ranges[vertex].y; ++i) {
        uvec4 triangle = triangles[entries[i] / 4u];
        uint corner = entries[i] % 4u;
        if (isSkin(triangle) && ((triangle.w >> (1u + corner)) & 1u) == 1u) {
            uint place = 3u * triangleCount + atomicAdd(rimCommand.y, 1u);
            if (place < uint(skinCorners.length())) {
                skinCorners[place] = entries[i];
            }
        }
    }
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
    bool hasSkin = skin != vec3(0);
    vec3 outside = unit(skin);
    bool isWhole = cutSkinNormals[vertex].xyz == vec3(0);
    if (!isWhole) {
        outside = wholeSkinNormal(vertex, outside);
    }
    writeCorners(vertex, outside);
    bool many = ranges[vertex].y - ranges[vertex].x > uint(kMostFan);
    bool hard = isWhole && hasSkin && isBent(vertex) &&
        (many ? writeSides(vertex) : writeParts(vertex));
    float bulge = isWhole ? 0.0 : length(cutSkinNormals[vertex].xyz) - 1.0;
    normals[2u * vertex] = vec4(outside, hasSkin && !hard ? 1.0 : 0.0);
    normals[2u * vertex + 1u] = vec4(unit(wall), bulge);
    noteRims(vertex);
}
