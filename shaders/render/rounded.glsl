// The displayed surface: each triangle in `pieces` times as many per side, bulged so that coarse
// skin has a round outline (Boubekeur and Alexa, "Phong tessellation", the bulge written as a sum
// over edges). What lies on an edge depends on its two ends alone, so the surface stays closed;
// hard edges stay straight, and so do those that lead away from the skin. Nothing of it reaches the
// simulation.
#include "body.glsl"
#include "roundness.h"
layout(std430, binding = kBindNormals) readonly buffer Normals { vec4 normals[]; };

// A vertex on the displayed surface: one that a cut made lies on a flat triangle of what was whole.
vec3 shownVertex(uint vertex) {
    return positions[vertex].xyz + normals[2u * vertex + 1u].w * normals[2u * vertex].xyz;
}

// Four times how far the middle of an edge bulges towards the planes of its ends.
vec3 edgeBulge(vec3 along, vec4 first, vec4 second) {
    bool round = first.w * second.w > 0.0 && dot(first.xyz, second.xyz) > kLeastAgreement;
    return round ? dot(along, first.xyz) * first.xyz - dot(along, second.xyz) * second.xyz
                 : vec3(0);
}

// The point of a triangle with these weights of its corners.
vec3 roundedPoint(uvec3 corners, vec3 weights) {
    vec3 a = shownVertex(corners.x);
    vec3 b = shownVertex(corners.y);
    vec3 c = shownVertex(corners.z);
    vec4 na = normals[2u * corners.x];
    vec4 nb = normals[2u * corners.y];
    vec4 nc = normals[2u * corners.z];
    precise vec3 p = weights.x * a + weights.y * b + weights.z * c;
    precise vec3 bulge = weights.x * weights.y * edgeBulge(a - b, na, nb) +
        weights.y * weights.z * edgeBulge(b - c, nb, nc) +
        weights.z * weights.x * edgeBulge(c - a, nc, na);
    return p + kRoundness * bulge;
}

// Weights of the corners of a triangle at a corner of one of the pieces * pieces triangles in it,
// which lie in rows that widen from the first corner on.
vec3 pieceWeights(int piece, int corner, int pieces) {
    int row = int(sqrt(float(piece) + 0.5));
    int place = piece - row * row;
    int column = place >> 1;
    bool upright = (place & 1) == 0;
    int i = row + (corner == 0 || (!upright && corner == 2) ? 0 : 1);
    int j = column + (upright ? (corner == 2 ? 1 : 0) : (corner == 0 ? 0 : 1));
    return vec3(pieces - i, i - j, j) / float(pieces);
}
