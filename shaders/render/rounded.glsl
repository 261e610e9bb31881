// The displayed surface: each triangle in `pieces` times as many per side, bulged so that coarse
// skin has a round outline (Boubekeur and Alexa, "Phong tessellation"). What lies on an edge
// depends on its two ends alone, so the surface stays closed; hard edges stay straight. Nothing of
// it reaches the simulation.
#include "body.glsl"
layout(std430, binding = kBindNormals) readonly buffer Normals { vec4 normals[]; };

const float kRoundness = 0.75;

// A vertex on the displayed surface: one that a cut made lies on a flat triangle of what was whole.
vec3 shownVertex(uint vertex) {
    return positions[vertex].xyz + normals[2u * vertex + 1u].w * normals[2u * vertex].xyz;
}

// How much of a corner's plane a point takes over; nothing where the skin has a hard edge.
vec3 towardsPlane(vec3 p, vec3 corner, uint vertex, float weight) {
    vec4 normal = normals[2u * vertex];
    return (kRoundness * weight * normal.w * dot(corner - p, normal.xyz)) * normal.xyz;
}

// The point of a triangle with these weights of its corners.
vec3 roundedPoint(uvec3 corners, vec3 weights) {
    vec3 a = shownVertex(corners.x);
    vec3 b = shownVertex(corners.y);
    vec3 c = shownVertex(corners.z);
    precise vec3 p = weights.x * a + weights.y * b + weights.z * c;
    precise vec3 bulge = towardsPlane(p, a, corners.x, weights.x) +
        towardsPlane(p, b, corners.y, weights.y) + towardsPlane(p, c, corners.z, weights.z);
    return p + bulge;
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
