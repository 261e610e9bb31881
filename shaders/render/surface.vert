#include "rounded.glsl"
#include "corner_normals.glsl"
#include "piece_looks.glsl"
layout(std430, binding = kBindRestPositions) readonly buffer Rest { vec4 restPositions[]; };
layout(std430, binding = kBindCornerNormals) readonly buffer CornerNormals {
    uint cornerNormals[];  // of the skin: 3 * triangle + corner
};

#ifdef WALLS
const uint kKind = 1u;
#else
const uint kKind = 0u;
#endif

uniform mat4 viewProjection;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 restPosition;
out vec3 corners;  // weights of the corners of the triangle
flat out vec4 pieceTint;

vec3 cornerNormal(int triangle, uint vertex, int corner) {
#ifdef WALLS
    return normals[2u * vertex + 1u].xyz;
#else
    return unpackedNormal(cornerNormals[3 * triangle + corner]);
#endif
}

#ifdef ROUNDED
uniform int sidePieces;

void placeCorner(int id, uvec3 vertices) {
    int triangle = id / (3 * sidePieces * sidePieces);
    int local = id % (3 * sidePieces * sidePieces);
    corners = pieceWeights(local / 3, local % 3, sidePieces);
    worldPosition = roundedPoint(vertices, corners);
    restPosition = corners.x * restPositions[vertices.x].xyz +
        corners.y * restPositions[vertices.y].xyz + corners.z * restPositions[vertices.z].xyz;
    worldNormal = corners.x * cornerNormal(triangle, vertices.x, 0) +
        corners.y * cornerNormal(triangle, vertices.y, 1) +
        corners.z * cornerNormal(triangle, vertices.z, 2);
}
#else
const int sidePieces = 1;

void placeCorner(int id, uvec3 vertices) {
    int corner = id % 3;
    uint vertex = vertices[corner];
    corners = vec3(corner == 0, corner == 1, corner == 2);
    worldPosition = positions[vertex].xyz;
    restPosition = restPositions[vertex].xyz;
    worldNormal = cornerNormal(id / 3, vertex, corner);
}
#endif

void main() {
    uvec4 triangle = triangles[gl_VertexID / (3 * sidePieces * sidePieces)];
    placeCorner(gl_VertexID, triangle.xyz);
    worldPosition += shiftOfPiece(triangle);
    pieceTint = lookOfPiece(triangle);
    // Triangles of the other kind, and of hidden pieces, fall outside the picture.
    bool drawn = (triangle.w & 1u) == kKind && pieceTint.w >= 0.0;
    gl_Position = drawn ? viewProjection * vec4(worldPosition, 1) : vec4(2, 2, 2, 1);
}
