// What a work group changes as it solves a small body. On a GPU the displacements lie in shared
// memory. With LOAD_IMAGES, for llvmpipe, all of it is written as storage and read as images: that
// loads a vector at a time, while storage and shared memory are loaded lane by lane.

layout(std430, binding = kPositionsBinding) coherent buffer Positions { vec4 storedPositions[]; };
layout(std430, binding = kVelocitiesBinding) coherent buffer Velocities {
    vec4 storedVelocities[];
};
layout(std430, binding = kDisplacementBinding) coherent buffer Displacement {
    vec4 storedDisplacement[];
};
layout(std430, binding = kSmallCorrectionsBinding) coherent buffer Corrections {
    vec4 storedCorrections[];
};
layout(std430, binding = kSmallGradientsBinding) coherent buffer Gradients {
    vec4 storedGradients[];
};
layout(std430, binding = kSmallPartsBinding) coherent buffer Parts { vec2 storedParts[]; };

void setPosition(uint v, vec4 x) { storedPositions[v] = x; }
void setVelocity(uint v, vec3 u) { storedVelocities[v] = vec4(u, 0.0); }
void setCorrection(uint index, vec4 pull) { storedCorrections[index] = pull; }
void setGradient(uint v, vec3 gradient) { storedGradients[v] = vec4(gradient, 0.0); }
void setPart(uint place, vec2 sum) { storedParts[place] = sum; }

// d at the beginning of a sweep of plain PBD.
#ifdef PLAIN_PBD
layout(std430, binding = kSmallSweptBinding) coherent buffer Swept { vec4 storedSwept[]; };
void setSwept(uint v, vec3 d) { storedSwept[v] = vec4(d, 0.0); }
#ifdef LOAD_IMAGES
layout(binding = kSmallSweptBinding, rgba32f) coherent readonly uniform imageBuffer sweptTexels;
vec3 sweptOf(uint v) { return imageLoad(sweptTexels, int(v)).xyz; }
#else
vec3 sweptOf(uint v) { return storedSwept[v].xyz; }
#endif
#endif

// Which of `count` vertices or constraints a thread takes: from firstOf(count) every kStride-th
// below endOf(count). On llvmpipe eight threads that run side by side have a stretch of them, which
// stays in the cache.
#ifdef LOAD_IMAGES
const uint kStride = 8u;

uint stretchOf(uint count) {
    return (count + kSmallGroup - 1u) / kSmallGroup * kStride;
}

uint firstOf(uint count) {
    return gl_LocalInvocationID.x / kStride * stretchOf(count) + gl_LocalInvocationID.x % kStride;
}

uint endOf(uint count) {
    return min(count, (gl_LocalInvocationID.x / kStride + 1u) * stretchOf(count));
}
#else
const uint kStride = kSmallGroup;

uint firstOf(uint count) {
    return gl_LocalInvocationID.x;
}

uint endOf(uint count) {
    return count;
}
#endif

#ifdef LOAD_IMAGES
layout(binding = kPositionsBinding, rgba32f) coherent readonly uniform imageBuffer positionTexels;
layout(binding = kVelocitiesBinding, rgba32f) coherent readonly uniform imageBuffer velocityTexels;
layout(binding = kDisplacementBinding, rgba32f) coherent readonly uniform imageBuffer
    displacementTexels;
layout(binding = kSmallCorrectionsBinding, rgba32f) coherent readonly uniform imageBuffer
    correctionTexels;
layout(binding = kSmallGradientsBinding, rgba32f) coherent readonly uniform imageBuffer
    gradientTexels;
layout(binding = kSmallPartsBinding, rg32f) coherent readonly uniform imageBuffer partTexels;

vec4 positionOf(uint v) { return imageLoad(positionTexels, int(v)); }
vec4 velocityOf(uint v) { return imageLoad(velocityTexels, int(v)); }
vec4 correctionAt(uint index) { return imageLoad(correctionTexels, int(index)); }
vec3 gradientOf(uint v) { return imageLoad(gradientTexels, int(v)).xyz; }
vec2 partAt(uint place) { return imageLoad(partTexels, int(place)).xy; }
vec4 displacementOf(uint v) { return imageLoad(displacementTexels, int(v)); }
void setDisplacement(uint v, vec4 d) { storedDisplacement[v] = d; }
void loadDisplacements(uint self) {}
void storeDisplacements(uint self) {}
#else
vec4 positionOf(uint v) { return storedPositions[v]; }
vec4 velocityOf(uint v) { return storedVelocities[v]; }
vec4 correctionAt(uint index) { return storedCorrections[index]; }
vec3 gradientOf(uint v) { return storedGradients[v].xyz; }
vec2 partAt(uint place) { return storedParts[place]; }

// An array for each component: neighbouring threads then read neighbouring banks.
shared float displacementX[kSmallBodyVertices];
shared float displacementY[kSmallBodyVertices];
shared float displacementZ[kSmallBodyVertices];
shared float displacementW[kSmallBodyVertices];

vec4 displacementOf(uint v) {
    return vec4(displacementX[v], displacementY[v], displacementZ[v], displacementW[v]);
}

void setDisplacement(uint v, vec4 d) {
    displacementX[v] = d.x;
    displacementY[v] = d.y;
    displacementZ[v] = d.z;
    displacementW[v] = d.w;
}

void loadDisplacements(uint self) {
    for (uint v = self; v < uniforms.vertex_count; v += kSmallGroup) {
        setDisplacement(v, storedDisplacement[v]);
    }
}

void storeDisplacements(uint self) {
    for (uint v = self; v < uniforms.vertex_count; v += kSmallGroup) {
        storedDisplacement[v] = displacementOf(v);
    }
}
#endif

// Records of the contacts, and what unfolds: see sim/contact/answers.glsl, sim/unfold.
#ifdef UNFOLDS
layout(std430, binding = kSmallFoldsBinding) coherent buffer Folds { uint storedFolds[]; };
#ifdef LOAD_IMAGES
layout(binding = kFoldsUnit, r32ui) coherent readonly uniform uimageBuffer foldTexels;
float foldOrSum(uint place) { return uintBitsToFloat(imageLoad(foldTexels, int(place)).x); }
#else
float foldOrSum(uint place) { return uintBitsToFloat(storedFolds[place]); }
#endif
float foldAt(uint v) { return foldOrSum(v); }
float foldSumOf(uint v) { return foldOrSum(uniforms.vertex_count + v); }
void forgetFold(uint v) { storedFolds[v] = 0u; }
void raiseFold(uint v, float fold) { atomicMax(storedFolds[v], floatBitsToUint(fold)); }
void setFoldSum(uint v, float sum) {
    storedFolds[uniforms.vertex_count + v] = floatBitsToUint(sum);
}

// Goals lie where corrections do, which no other phase needs then.
UnfoldGoal goalAt(uint v) {
    uint first = 5u * v;
    return UnfoldGoal(correctionAt(first), correctionAt(first + 1u), correctionAt(first + 2u),
                      correctionAt(first + 3u), correctionAt(first + 4u));
}
void setGoal(uint v, UnfoldGoal goal) {
    setCorrection(5u * v, goal.rotation);
    setCorrection(5u * v + 1u, goal.center);
    setCorrection(5u * v + 2u, goal.rest_center);
    setCorrection(5u * v + 3u, goal.velocity);
    setCorrection(5u * v + 4u, goal.spin);
}
#endif

#ifdef COLLIDES
layout(std430, binding = kSmallContactBinding) readonly buffer Contact {
    ContactUniforms storedContact;
};
ContactUniforms contact = storedContact;
layout(std430, binding = kSmallRecordsBinding) coherent buffer Records { ContactRecord records[]; };
layout(std430, binding = kSmallSumsBinding) coherent buffer Sums { int sums[]; };
layout(std430, binding = kSmallStateBinding) coherent buffer State {
    ContactState state;
    uint shares[];
};
void takeShare(uint v, uint share) { atomicAdd(shares[v], share); }
uint shareTaken(uint v) { return shares[v]; }
void clearShare(uint v) { shares[v] = 0u; }
#endif

#ifdef MEETS_BOXES
layout(std430, binding = kSmallObstacleBinding) readonly buffer Obstacle {
    BoxUniforms storedObstacle;
};
BoxUniforms obstacle = storedObstacle;
layout(std430, binding = kSmallTouchesBinding) coherent buffer Touches { BoxTouch touches[]; };
STATE_TEXELS(kSmallBoxesUnit) boxes;
RECORD_WORDS(kSmallPieceBoundsUnit) boundsOfPieces;
#include "sim/boxes/fetched.glsl"
#endif

// What the group wrote can be read by all of it.
void endPhase() {
    memoryBarrier();
    barrier();
}
