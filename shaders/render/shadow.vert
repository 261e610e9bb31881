// Depth of the body from a light, or from below the floor.
#include "body.glsl"
uniform mat4 lightMatrix;

void main() {
    uint vertex = triangles[gl_VertexID / 3][gl_VertexID % 3];
    gl_Position = lightMatrix * vec4(positions[vertex].xyz, 1);
}
