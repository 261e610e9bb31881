// What the phases of answers.glsl read and write, for kernels of one phase.
#include "bindings.h"
#include "body_records.h"
#include "contact_bindings.h"
#include "contact_records.h"

layout(local_size_x = kGroupSize) in;
// Copied before anything branches, as those of the solver (sim/uniforms.glsl).
layout(std430, binding = kContactUniformsBinding) readonly buffer Uniforms {
    ContactUniforms storedContact;
};
ContactUniforms contact = storedContact;
layout(std430, binding = kContactPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kContactDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kContactTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
layout(std430, binding = kContactNormalsBinding) readonly buffer Normals { vec4 normals[]; };
layout(std430, binding = kContactCandidatesBinding) readonly buffer Candidates {
    ContactCandidate candidates[];
};
layout(std430, binding = kContactEdgePairsBinding) readonly buffer Pairs { EdgePair pairs[]; };
layout(std430, binding = kContactPointsBinding) readonly buffer Points { uint points[]; };
layout(std430, binding = kContactRecordsBinding) buffer Records { ContactRecord records[]; };
layout(std430, binding = kContactSumsBinding) buffer Sums { int sums[]; };
layout(std430, binding = kContactStateBinding) buffer State {
    ContactState state;
    uint shares[];  // what contacts take of each vertex
};
#ifdef UNFOLDS
layout(std430, binding = kContactLinksBinding) readonly buffer Links { VertexLinks links[]; };
uint pieceOf(uint v) { return links[v].piece; }
#endif

vec4 positionOf(uint v) { return positions[v]; }
vec4 displacementOf(uint v) { return displacement[v]; }
void setPosition(uint v, vec4 x) { positions[v] = x; }
void setDisplacement(uint v, vec4 d) { displacement[v] = d; }
vec3 normalOf(uint v) { return normals[v].xyz; }
uvec4 triangleAt(uint t) { return triangles[t]; }
uint pointAt(uint index) { return points[index]; }
ContactCandidate candidateAt(uint place) { return candidates[place]; }
EdgePair edgePairAt(uint place) { return pairs[place]; }
void takeShare(uint v, uint share) { atomicAdd(shares[v], share); }
uint shareTaken(uint v) { return shares[v]; }
void clearShare(uint v) { shares[v] = 0u; }
