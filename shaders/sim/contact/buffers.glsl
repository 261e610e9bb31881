// What the phases of answers.glsl read and write, for kernels of one phase.
#include "bindings.h"
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"
#include "sim/base/fetch.glsl"

layout(local_size_x = kGroupSize) in;
// Copied before anything branches, as those of the solver (sim/base/uniforms.glsl).
layout(std430, binding = kContactUniformsBinding) readonly buffer Uniforms {
    ContactUniforms storedContact;
};
ContactUniforms contact = storedContact;
#ifdef APPLIES
layout(std430, binding = kContactPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactDisplacementBinding) buffer Displacement { vec4 displacement[]; };
vec4 positionOf(uint v) { return positions[v]; }
vec4 displacementOf(uint v) { return displacement[v]; }
void setPosition(uint v, vec4 x) { positions[v] = x; }
void setDisplacement(uint v, vec4 d) { displacement[v] = d; }
#else
STATE_TEXELS(kContactPositionsBinding) positions;
STATE_TEXELS(kContactDisplacementBinding) displacement;
vec4 positionOf(uint v) { return fetch(positions, v); }
vec4 displacementOf(uint v) { return fetch(displacement, v); }
void setPosition(uint v, vec4 x) {}
void setDisplacement(uint v, vec4 d) {}
#endif
layout(std430, binding = kContactRecordsBinding) buffer Records { ContactRecord records[]; };
layout(std430, binding = kContactSumsBinding) buffer Sums { int sums[]; };
layout(std430, binding = kContactStateBinding) buffer State {
    ContactState state;
    uint shares[];  // what contacts take of each vertex
};

void takeShare(uint v, uint share) { atomicAdd(shares[v], share); }
uint shareTaken(uint v) { return shares[v]; }
void clearShare(uint v) { shares[v] = 0u; }
