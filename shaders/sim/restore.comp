// Takes pieces that were lost back to the saved positions, at rest. Reads links, saved positions,
// marks. Writes X and velocities. One thread per vertex. A storage barrier follows.
#include "sim/base/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kVelocitiesBinding) writeonly buffer Velocities { vec4 velocities[]; };
layout(std430, binding = kLinksBinding) readonly buffer Links { VertexLinks links[]; };
layout(std430, binding = kSavedBinding) readonly buffer Saved { vec4 saved[]; };
layout(std430, binding = kMarksBinding) readonly buffer Marks { uint marks[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uniforms.vertex_count) return;
    if (links[v].piece == kNoPiece || marks[links[v].piece] == 0u) return;
    positions[v] = vec4(saved[v].xyz, positions[v].w);
    velocities[v] = vec4(0.0);
}
