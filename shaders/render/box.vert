// A box: flat faces, and how far each point lies from the two edges that meet at corner 0 and from
// the two opposite ones.
#include "body.glsl"
uniform mat4 viewProjection;
out vec3 worldPosition;
flat out vec3 worldNormal;
out vec2 along;       // from the sides through the right angle [m]
flat out vec2 sides;  // lengths of the face [m]

void main() {
    uvec4 t = triangles[gl_VertexID / 3];
    int self = gl_VertexID % 3;
    vec3 a = positions[t.x].xyz;
    vec3 ab = positions[t.y].xyz - a;
    vec3 ac = positions[t.z].xyz - a;
    worldPosition = positions[t[self]].xyz;
    worldNormal = normalize(cross(ab, ac));
    sides = vec2(length(ab), length(ac));
    along = vec2(self == 1 ? sides.x : 0.0, self == 2 ? sides.y : 0.0);
    gl_Position = viewProjection * vec4(worldPosition, 1);
}
