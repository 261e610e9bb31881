// The blade: a knife's cross-section drawn along AB, built on the CPU.
#include "render_bindings.h"
struct BladeVertex {
    vec4 position;  // w: height above the cutting edge, 0 to 1
    vec4 normal;    // w: shine, 1 on the ground bevel, 0 on the flat, less on the back
};
layout(std430, binding = kBindSegments) readonly buffer Vertices { BladeVertex vertices[]; };

uniform mat4 viewProjection;
out vec3 worldPosition;
out vec3 worldNormal;
out float height;
out float shine;

void main() {
    BladeVertex vertex = vertices[gl_VertexID];
    worldPosition = vertex.position.xyz;
    worldNormal = vertex.normal.xyz;
    shine = vertex.normal.w;
    height = vertex.position.w;
    gl_Position = viewProjection * vec4(worldPosition, 1);
}
