// Depth of the body from a light, or from below the floor.
#include "body.glsl"
#include "piece_looks.glsl"
#ifdef SECTION
#include "section.glsl"
#endif
uniform mat4 lightMatrix;

void main() {
    uvec4 triangle = triangles[gl_VertexID / 3];
    uint vertex = triangle[gl_VertexID % 3];
    bool drawn = lookOfPiece(triangle).w >= 0.0;
    // Depth is clamped in these pictures: what is not drawn falls outside by x and y.
    vec3 at = positions[vertex].xyz + shiftOfPiece(triangle);
#ifdef SECTION
    hideBehindSection(at);
#endif
    gl_Position = drawn ? lightMatrix * vec4(at, 1) : vec4(2, 2, 2, 1);
}
