// The motion of what is held, in a step; with CARRIES moves it. Reads X (inverse mass) and
// velocities. One thread per vertex. A storage barrier follows.
#include "sim/implicit/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
STATE_TEXELS(kVelocitiesBinding) velocities;
layout(std430, binding = kPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kDirectionBinding) writeonly buffer Directions { vec4 directions[]; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= implicit.vertex_count) return;
    bool held = !(positions[v].w > 0.0);
    vec4 way = held ? vec4(implicit.step * fetch(velocities, v).xyz, 0.0) : vec4(0.0);
#ifdef CARRIES
    positions[v] += way;
#else
    directions[v] = way;
#endif
}
