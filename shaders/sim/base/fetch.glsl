// Elements of buffers that a kernel reads through texture units (gpu::Buffer::bindTexels). A
// buffer's unit has the number of its storage binding.
#pragma once
#include "body_records.h"

// STATE_TEXELS declares what changes within a step; RECORD_QUADS, RECORD_PAIRS and RECORD_WORDS
// what only a cut changes, by the words of a texel. With LOAD_IMAGES, for llvmpipe, all of these
// are images: it calls a function for each fetch of a texel, around which all variables go to
// memory, but loads images in place.
#ifdef LOAD_IMAGES
#define STATE_TEXELS(unit) layout(binding = unit, rgba32f) readonly uniform imageBuffer
#define RECORD_QUADS(unit) layout(binding = unit, rgba32ui) readonly uniform uimageBuffer
#define RECORD_PAIRS(unit) layout(binding = unit, rg32ui) readonly uniform uimageBuffer
#define RECORD_WORDS(unit) layout(binding = unit, r32ui) readonly uniform uimageBuffer
#define fetch(texels, index) imageLoad(texels, int(index))
#else
#define STATE_TEXELS(unit) layout(binding = unit) uniform samplerBuffer
#define RECORD_QUADS(unit) layout(binding = unit) uniform usamplerBuffer
#define RECORD_PAIRS(unit) layout(binding = unit) uniform usamplerBuffer
#define RECORD_WORDS(unit) layout(binding = unit) uniform usamplerBuffer
#define fetch(texels, index) texelFetch(texels, int(index))
#endif

// The lists by which the vertices gather (constraints.h).
#define RANGES_OF_WingPulls(unit) RECORD_QUADS(unit)
#define ENTRIES_OF_WingPulls(unit) RECORD_PAIRS(unit)
#define RANGES_OF_Shares(unit) RECORD_PAIRS(unit)
#define ENTRIES_OF_Shares(unit) RECORD_QUADS(unit)

// No function takes a list: images have formats, which GLSL has no word for in parameters.
Spoke spokeOf(uvec4 words) {
    return Spoke(words.x, uintBitsToFloat(words.y), uintBitsToFloat(words.z), words.w);
}
#define fetchSpoke(records, index) spokeOf(fetch(records, index))

BendRecord bendOf(uvec4 v, uvec4 words) {
    vec4 rest = uintBitsToFloat(words);
    return BendRecord(v.x, v.y, v.z, v.w, rest.x, rest.y, rest.z, rest.w);
}
#define fetchBend(records, index) \
    bendOf(fetch(records, 2u * (index)), fetch(records, 2u * (index) + 1u))

BendRange bendRangeOf(uvec4 words) {
    return BendRange(words.x, words.y, words.z, 0u);
}
