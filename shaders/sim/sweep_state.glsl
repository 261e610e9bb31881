// What a work group changes as it sweeps a body. On a GPU the displacements lie in shared memory.
// With LOAD_IMAGES, for llvmpipe, all of it is written as storage and read as images: that loads a
// vector at a time, while storage and shared memory are loaded lane by lane.

layout(std430, binding = kPositionsBinding) coherent buffer Positions { vec4 storedPositions[]; };
layout(std430, binding = kVelocitiesBinding) coherent buffer Velocities {
    vec4 storedVelocities[];
};
layout(std430, binding = kDisplacementBinding) coherent buffer Displacement {
    vec4 storedDisplacement[];
};
layout(std430, binding = kSweepCorrectionsBinding) coherent buffer Corrections {
    vec4 storedCorrections[];
};
layout(std430, binding = kSweptBinding) coherent buffer Swept { vec4 storedSwept[]; };

void setPosition(uint v, vec4 x) { storedPositions[v] = x; }
void setVelocity(uint v, vec3 u) { storedVelocities[v] = vec4(u, 0.0); }
void setCorrection(uint index, vec4 pull) { storedCorrections[index] = pull; }
// d at the beginning of a sweep.
void setSwept(uint v, vec3 d) { storedSwept[v] = vec4(d, 0.0); }

// Which of `count` vertices or constraints a thread takes: from firstOf(count) every kStride-th
// below endOf(count). On llvmpipe eight threads that run side by side have a stretch of them, which
// stays in the cache.
#ifdef LOAD_IMAGES
const uint kStride = 8u;

uint stretchOf(uint count) {
    return (count + kSweepGroup - 1u) / kSweepGroup * kStride;
}

uint firstOf(uint count) {
    return gl_LocalInvocationID.x / kStride * stretchOf(count) + gl_LocalInvocationID.x % kStride;
}

uint endOf(uint count) {
    return min(count, (gl_LocalInvocationID.x / kStride + 1u) * stretchOf(count));
}

layout(binding = kPositionsBinding, rgba32f) coherent readonly uniform imageBuffer positionTexels;
layout(binding = kVelocitiesBinding, rgba32f) coherent readonly uniform imageBuffer velocityTexels;
layout(binding = kDisplacementBinding, rgba32f) coherent readonly uniform imageBuffer
    displacementTexels;
layout(binding = kSweepCorrectionsBinding, rgba32f) coherent readonly uniform imageBuffer
    correctionTexels;
layout(binding = kSweptBinding, rgba32f) coherent readonly uniform imageBuffer sweptTexels;

vec4 positionOf(uint v) { return imageLoad(positionTexels, int(v)); }
vec4 velocityOf(uint v) { return imageLoad(velocityTexels, int(v)); }
vec4 correctionAt(uint index) { return imageLoad(correctionTexels, int(index)); }
vec3 sweptOf(uint v) { return imageLoad(sweptTexels, int(v)).xyz; }
vec4 displacementOf(uint v) { return imageLoad(displacementTexels, int(v)); }
void setDisplacement(uint v, vec4 d) { storedDisplacement[v] = d; }
void storeDisplacements() {}
#else
const uint kStride = kSweepGroup;

uint firstOf(uint count) {
    return gl_LocalInvocationID.x;
}

uint endOf(uint count) {
    return count;
}

vec4 positionOf(uint v) { return storedPositions[v]; }
vec4 velocityOf(uint v) { return storedVelocities[v]; }
vec4 correctionAt(uint index) { return storedCorrections[index]; }
vec3 sweptOf(uint v) { return storedSwept[v].xyz; }

// An array for each component: neighbouring threads then read neighbouring banks.
shared float displacementX[kSharedSweepVertices];
shared float displacementY[kSharedSweepVertices];
shared float displacementZ[kSharedSweepVertices];
shared float displacementW[kSharedSweepVertices];

vec4 displacementOf(uint v) {
    return vec4(displacementX[v], displacementY[v], displacementZ[v], displacementW[v]);
}

void setDisplacement(uint v, vec4 d) {
    displacementX[v] = d.x;
    displacementY[v] = d.y;
    displacementZ[v] = d.z;
    displacementW[v] = d.w;
}

void storeDisplacements() {
    for (uint v = firstOf(uniforms.vertex_count); v < uniforms.vertex_count; v += kStride) {
        storedDisplacement[v] = displacementOf(v);
    }
}
#endif

// What the group wrote can be read by all of it.
void endPhase() {
    memoryBarrier();
    barrier();
}
