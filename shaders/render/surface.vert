#include "rounded.glsl"
#include "corner_normals.glsl"
#include "piece_looks.glsl"
#ifdef SECTION
#include "section.glsl"
#endif
layout(std430, binding = kBindRestPositions) readonly buffer Rest { vec4 restPositions[]; };
#define SKIN_CORNERS_ACCESS readonly
#include "skin_corners.glsl"

#ifdef OWN_COLOURS
#include "skin_records.h"
layout(std430, binding = kBindSkin) readonly buffer Skin { SkinRecord skinRecords[]; };
out vec2 skinUv;
out vec4 skinTint;

void paintCorner(SkinRecord record, int corner) {
    SkinCorner at = corner == 0 ? record.first : corner == 1 ? record.second : record.third;
    skinUv = vec2(at.u, at.v);
    skinTint = vec4(unpackHalf2x16(at.red_green), unpackHalf2x16(at.blue_own));
}
#endif

#ifdef WALLS
out float torn;  // 1 where a tear made the wall, 0 where a blade did
const uint kKind = 1u;
#else
const uint kKind = 0u;
#endif

uniform mat4 viewProjection;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 restPosition;
out vec3 corners;  // weights of the corners of the triangle
#ifdef FIELD
#define FIELD_ACCESS readonly
#include "field.glsl"
uniform vec2 fieldRange;
out float fieldPlace;  // in the range of its colours, 0 to 1
#endif
flat out vec4 pieceTint;

vec3 cornerNormal(int triangle, uint vertex, int corner) {
#ifdef WALLS
    return normals[2u * vertex + 1u].xyz;
#else
    return unpackedNormal(skinCorners[3 * triangle + corner]);
#endif
}

#ifdef ROUNDED
uniform int sidePieces;

int triangleOf(int id) { return id / (3 * sidePieces * sidePieces); }

void placeCorner(int id, int triangle, uvec3 vertices) {
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
int triangleOf(int id) {
#ifdef OWN_COLOURS
    return int(skinRecords[id / 3].triangle);
#else
    return id / 3;
#endif
}

void placeCorner(int id, int triangle, uvec3 vertices) {
    int corner = id % 3;
    uint vertex = vertices[corner];
    corners = vec3(corner == 0, corner == 1, corner == 2);
    worldPosition = positions[vertex].xyz;
    restPosition = restPositions[vertex].xyz;
    worldNormal = cornerNormal(triangle, vertex, corner);
#ifdef OWN_COLOURS
    paintCorner(skinRecords[id / 3], corner);
#endif
#ifdef FIELD
    fieldPlace = (fieldValues[2u * vertex + kKind] - fieldRange.x) / (fieldRange.y - fieldRange.x);
#endif
}
#endif

void main() {
    int number = triangleOf(gl_VertexID);
    uvec4 triangle = triangles[number];
    placeCorner(gl_VertexID, number, triangle.xyz);
#ifdef WALLS
    torn = dot(corners, vec3((triangle.www >> uvec3(4u, 5u, 6u)) & 1u));
#endif
    worldPosition += shiftOfPiece(triangle);
#ifdef SECTION
    hideBehindSection(worldPosition);
#endif
    pieceTint = lookOfPiece(triangle);
    // Triangles of the other kind, and of hidden pieces, fall outside the picture.
    bool drawn = (triangle.w & 1u) == kKind && pieceTint.w >= 0.0;
    gl_Position = drawn ? viewProjection * vec4(worldPosition, 1) : vec4(2, 2, 2, 1);
}
