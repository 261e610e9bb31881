#include "body.glsl"
#include "piece_looks.glsl"
#ifdef SECTION
#include "section.glsl"
#endif
layout(std430, binding = kBindRestPositions) readonly buffer Rest { vec4 restPositions[]; };
layout(std430, binding = kBindNormals) readonly buffer Normals { vec4 normals[]; };

#ifdef OWN_COLOURS
#include "skin_records.h"
layout(std430, binding = kBindSkin) readonly buffer Skin { SkinRecord skinRecords[]; };
out vec2 skinUv;
out vec4 skinTint;

// Tells which triangle of the body is drawn, and paints this corner of it.
uint paintCorner(int corner) {
    SkinRecord record = skinRecords[gl_VertexID / 3];
    SkinCorner at = corner == 0 ? record.first : corner == 1 ? record.second : record.third;
    skinUv = vec2(at.u, at.v);
    skinTint = vec4(unpackHalf2x16(at.red_green), unpackHalf2x16(at.blue_own));
    return record.triangle;
}
#endif

#ifdef WALLS
const uint kKind = 1u;
#else
const uint kKind = 0u;
#endif

uniform mat4 viewProjection;
uniform float facets;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 restPosition;
out vec3 corners;
#ifdef FIELD
#define FIELD_ACCESS readonly
#include "field.glsl"
out float fieldPlace;  // in the range of its colours, 0 to 1
#endif
flat out vec4 pieceTint;
#ifndef WALLS
flat out vec3 rims;  // by corner: 1 where the edge opposite to it lies on the rim of a cut
#endif

vec3 faceNormal(uvec4 triangle) {
    vec3 a = positions[triangle.x].xyz;
    vec3 n = cross(positions[triangle.y].xyz - a, positions[triangle.z].xyz - a);
    float size = length(n);
    return size > 0.0 ? n / size : vec3(0);
}

void main() {
    int corner = gl_VertexID % 3;
#ifdef OWN_COLOURS
    uvec4 triangle = triangles[paintCorner(corner)];
#else
    uvec4 triangle = triangles[gl_VertexID / 3];
#endif
    uint vertex = triangle[corner];
    worldPosition = positions[vertex].xyz + shiftOfPiece(triangle);
    restPosition = restPositions[vertex].xyz;
    worldNormal = normals[2u * vertex + kKind].xyz;
#ifndef WALLS
    worldNormal = mix(worldNormal, faceNormal(triangle), facets);
    rims = vec3((triangle.www >> uvec3(2u, 3u, 1u)) & 1u);
#endif
#ifdef FIELD
    fieldPlace = (fieldValues[2u * vertex + kKind] - rangeLow) / (rangeHigh - rangeLow);
#endif
#ifdef SECTION
    hideBehindSection(worldPosition);
#endif
    corners = vec3(corner == 0, corner == 1, corner == 2);
    pieceTint = lookOfPiece(triangle);
    // Triangles of the other kind, and of hidden pieces, fall outside the picture.
    bool drawn = (triangle.w & 1u) == kKind && pieceTint.w >= 0.0;
    gl_Position = drawn ? viewProjection * vec4(worldPosition, 1) : vec4(2, 2, 2, 1);
}
