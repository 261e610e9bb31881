// A large square in the plane of the floor, around the point below the target.
uniform mat4 viewProjection;
uniform float floorHeight;
uniform vec2 floorCenter;
uniform float floorReach;
out vec3 worldPosition;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec2 xz = floorCenter + floorReach * corner;
    worldPosition = vec3(xz.x, floorHeight, xz.y);
    gl_Position = viewProjection * vec4(worldPosition, 1);
}
