// The outward normal of each vertex: the sum of its triangles' area vectors over the sum of their
// lengths, so 1 long where the surface is flat and short at tips and at the front of a slit. In w,
// as bits, what its triangles are.
// Reads positions (current or rest), triangles and their incidence. Writes normals, and starts the
// counts of a search anew. One thread per vertex. A storage barrier follows.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) readonly buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactRangesBinding) readonly buffer Ranges { IncidenceRange ranges[]; };
layout(std430, binding = kContactIncidenceBinding) readonly buffer Incidence { uint incidence[]; };
layout(std430, binding = kContactNormalsBinding) writeonly buffer Normals { vec4 normals[]; };
layout(std430, binding = kContactStateBinding) writeonly buffer State { ContactState state; };

void startAnew() {
    state.point_groups = 0u;
    state.point_groups_y = 1u;
    state.point_groups_z = 1u;
    state.vertex_groups = 0u;
    state.vertex_groups_y = 1u;
    state.vertex_groups_z = 1u;
    state.points = 0u;
    state.contacts = 0u;
    state.last_contacts = 0u;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v == 0u) {
        startAnew();
    }
    if (v >= uniforms.vertex_count) return;
    vec3 sum = vec3(0.0);
    float area = 0.0;
    uint kinds = 0u;
    for (uint k = ranges[v].first; k < ranges[v].end; ++k) {
        uvec4 t = triangles[incidence[k] >> 2];
        vec3 a = positions[t.x].xyz;
        vec3 normal = cross(positions[t.y].xyz - a, positions[t.z].xyz - a);
        sum += normal;
        area += length(normal);
        kinds |= (t.w & 1u) != 0u ? kTouchesWall : kTouchesSkin;
    }
    normals[v] = vec4(area > 0.0 ? sum / area : vec3(0.0), uintBitsToFloat(kinds));
}
