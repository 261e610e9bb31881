#include "body.glsl"
layout(std430, binding = kBindRestPositions) readonly buffer Rest { vec4 restPositions[]; };
layout(std430, binding = kBindNormals) readonly buffer Normals { vec4 normals[]; };

uniform mat4 viewProjection;
uniform float facets;

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 restPosition;
out vec3 corners;
flat out uint kind;

vec3 faceNormal(uvec4 triangle) {
    vec3 a = positions[triangle.x].xyz;
    vec3 n = cross(positions[triangle.y].xyz - a, positions[triangle.z].xyz - a);
    float size = length(n);
    return size > 0.0 ? n / size : vec3(0);
}

void main() {
    uvec4 triangle = triangles[gl_VertexID / 3];
    int corner = gl_VertexID % 3;
    uint vertex = triangle[corner];
    kind = triangle.w & 1u;
    worldPosition = positions[vertex].xyz;
    restPosition = restPositions[vertex].xyz;
    worldNormal = normals[2u * vertex + kind].xyz;
    if (facets > 0.0 && kind == 0u) {
        worldNormal = mix(worldNormal, faceNormal(triangle), facets);
    }
    corners = vec3(corner == 0, corner == 1, corner == 2);
    gl_Position = viewProjection * vec4(worldPosition, 1);
}
