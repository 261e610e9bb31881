// Each vertex takes the mean of what triangles of other pieces ask of its own triangles in the
// paper's contact: the loss of velocity, which moves it too, and the push, which changes its
// position alone. Reads requests, triangles around each vertex. Changes X and velocities of what
// has mass, and the number of contacts. One thread per vertex. A storage barrier follows.
#include "sim/contact/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kContactPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactVelocitiesBinding) buffer Velocities { vec4 velocities[]; };
layout(std430, binding = kPaperRequestsBinding) readonly buffer Requests {
    PaperRequest requests[];
};
layout(std430, binding = kPaperRangesBinding) readonly buffer Ranges { IncidenceRange ranges[]; };
layout(std430, binding = kPaperIncidenceBinding) readonly buffer Incidence { uint incidence[]; };
layout(std430, binding = kContactStateBinding) buffer State { ContactState state; };

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v == 0u) {
        state.last_contacts = state.contacts;
    }
    if (v >= uniforms.vertex_count || positions[v].w <= 0.0) return;
    ivec3 loss = ivec3(0);
    ivec3 push = ivec3(0);
    uint count = 0u;
    for (uint k = ranges[v].first; k < ranges[v].end; ++k) {
        PaperRequest asked = requests[incidence[k] >> 2];
        loss += ivec3(asked.loss_x, asked.loss_y, asked.loss_z);
        push += ivec3(asked.push_x, asked.push_y, asked.push_z);
        count += asked.count;
    }
    if (count == 0u) return;
    float share = uniforms.unit / float(count);
    vec3 lost = share * vec3(loss);
    positions[v] = vec4(positions[v].xyz + lost + share * vec3(push), positions[v].w);
    velocities[v] = vec4(velocities[v].xyz + lost / uniforms.interval, velocities[v].w);
}
