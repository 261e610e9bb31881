// A square of the section plane about the body.
uniform mat4 viewProjection;
uniform vec3 sectionMiddle;
uniform vec3 sectionAlong;  // two halves of sides [m]
uniform vec3 sectionAcross;

out vec3 worldPosition;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    worldPosition = sectionMiddle + corner.x * sectionAlong + corner.y * sectionAcross;
    gl_Position = viewProjection * vec4(worldPosition, 1);
}
