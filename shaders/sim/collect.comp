// Fills in the records of vertices that are asked for by number. Reads X, velocities. Writes
// records. One thread per record. A storage barrier follows.
#include "bindings.h"
#include "body_records.h"
layout(local_size_x = kGroupSize) in;

#include "sim/base/fetch.glsl"

layout(binding = kPositionsBinding) uniform samplerBuffer positions;
layout(binding = kVelocitiesBinding) uniform samplerBuffer velocities;
layout(std430, binding = kNearbyBinding) buffer Nearby {
    NearbyQuery query;
    NearbyVertex nearby[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= query.asked_vertices) return;
    uint v = nearby[i].vertex;
    vec3 p = fetch(positions, v).xyz;
    vec3 u = fetch(velocities, v).xyz;
    nearby[i] = NearbyVertex(v, p.x, p.y, p.z, u.x, u.y, u.z, 0u);
}
