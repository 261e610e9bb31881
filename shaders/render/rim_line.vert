// The edges on the rims of cuts as lines: an instance each, in as many pieces as the displayed
// surface has on a side.
#include "rounded.glsl"
#include "piece_looks.glsl"
#include "thick_line.glsl"
#ifdef SECTION
#include "section.glsl"
#endif
#define SKIN_CORNERS_ACCESS readonly
#include "skin_corners.glsl"
uniform uint triangleCount;
uniform int sidePieces;

vec3 pointOfRim(uvec3 ends, int at) {
    if (sidePieces == 1) {
        return positions[at == 0 ? ends.x : ends.y].xyz;
    }
    return roundedPoint(ends, vec3(sidePieces - at, at, 0) / float(sidePieces));
}

void main() {
    uint entry = skinCorners[3u * triangleCount + uint(gl_InstanceID)];
    uvec4 triangle = triangles[entry / 4u];
    uint corner = entry % 4u;
    uvec3 ends = uvec3(triangle[corner], triangle[(corner + 1u) % 3u], triangle[corner]);
    int piece = gl_VertexID / 6;
    vec3 shift = shiftOfPiece(triangle);
    bool drawn = lookOfPiece(triangle).w >= 0.0;
    vec3 from = pointOfRim(ends, piece) + shift;
    vec3 to = pointOfRim(ends, piece + 1) + shift;
    vec4 place = lineCorner(from, to, gl_VertexID % 6);
#ifdef SECTION
    hideBehindSection(0.5 * (from + to));
#endif
    gl_Position = drawn ? place : vec4(2, 2, 2, 1);
}
