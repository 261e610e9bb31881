// What the instrumented kernels call (quirk_shader.py). All names begin with kerf: the rest of a
// kernel is instrumented, these are not.
layout(binding = 63, r32ui) coherent uniform uimageBuffer kerfWatch;  // quirk_driver.cpp fills it

const uint kerfFaults = 8u;      // first word of the list; words 0 to 2: how many, always 0,
                                 // kerfSlice
const uint kerfMostFaults = 64u;
const uint kerfBases = 512u;     // first shadow of each storage block, by binding, and of each
                                 // texture buffer, by 64 + unit
const uint kerfStrides = 768u;   // words of an element of each
const uint kerfShared = 1024u;   // shadows of shared memory, for kerfSharedSlots groups in turn
const uint kerfSharedSlots = 16u;
const uint kerfSharedWords = 8192u;
const uint kerfSharedBinding = 255u;

uvec4 kerfFault = uvec4(0u);  // of this invocation, the first: kind, line, and two words about it

void kerfNote(const in uint kind, const in uint site, const in uint a, const in uint b) {
    kerfFault = kerfFault.x == 0u ? uvec4(kind, site, a, b) : kerfFault;
}

/// At the end of each invocation.
void kerfReport() {
    if (kerfFault.x == 0u) return;
    uint n = imageAtomicAdd(kerfWatch, 0, 1u);
    if (n >= kerfMostFaults) return;
    for (uint i = 0u; i < 4u; ++i) {
        imageStore(kerfWatch, int(kerfFaults + 4u * n + i), uvec4(kerfFault[i]));
    }
}

// --- denormals: what GLSL 4.7.1 lets a driver do with them ---------------------------------------

float kerfFlush(const in float x) {
    uint bits = floatBitsToUint(x);
    return (bits & 0x7f800000u) == 0u ? uintBitsToFloat(bits & 0x80000000u) : x;
}
vec2 kerfFlush(const in vec2 v) { return vec2(kerfFlush(v.x), kerfFlush(v.y)); }
vec3 kerfFlush(const in vec3 v) { return vec3(kerfFlush(v.xy), kerfFlush(v.z)); }
vec4 kerfFlush(const in vec4 v) { return vec4(kerfFlush(v.xy), kerfFlush(v.zw)); }

// --- contraction: a * b + c rounded once ---------------------------------------------------------

float kerfFma(const in float a, const in float b, const in float c) {
    return float(double(a) * double(b) + double(c));
}
vec2 kerfFma(const in vec2 a, const in vec2 b, const in vec2 c) {
    return vec2(dvec2(a) * dvec2(b) + dvec2(c));
}
vec3 kerfFma(const in vec3 a, const in vec3 b, const in vec3 c) {
    return vec3(dvec3(a) * dvec3(b) + dvec3(c));
}
vec4 kerfFma(const in vec4 a, const in vec4 b, const in vec4 c) {
    return vec4(dvec4(a) * dvec4(b) + dvec4(c));
}
vec3 kerfCross(const in vec3 a, const in vec3 b) {
    return kerfFma(a.yzx, b.zxy, -(a.zxy * b.yzx));
}
float kerfDot(const in vec2 a, const in vec2 b) { return kerfFma(a.y, b.y, a.x * b.x); }
float kerfDot(const in vec3 a, const in vec3 b) { return kerfFma(a.z, b.z, kerfDot(a.xy, b.xy)); }
float kerfDot(const in vec4 a, const in vec4 b) {
    return kerfFma(a.w, b.w, kerfDot(a.xyz, b.xyz));
}

// --- groups: in another order --------------------------------------------------------------------

uint kerfCommonDivisor(const in uint a, const in uint b) {
    uint m = a;
    uint n = b;
    while (n != 0u) {
        uint rest = m % n;
        m = n;
        n = rest;
    }
    return m;
}

/// The group in whose place this one works: i * k, with no divisor in common, from the last one on.
uint kerfPlaceOfGroup(const in uint i, const in uint count) {
    uint k = count * 5u / 8u + 1u;
    while (kerfCommonDivisor(k, count) != 1u) ++k;
    return (count - 1u - i) * k % count;
}
uvec3 kerfGroup() {
    return uvec3(kerfPlaceOfGroup(gl_WorkGroupID.x, gl_NumWorkGroups.x), gl_WorkGroupID.yz);
}
uvec3 kerfInvocation() { return kerfGroup() * gl_WorkGroupSize + gl_LocalInvocationID; }

// --- dead: branches that are never taken ---------------------------------------------------------

uint kerfZero = 0u;  // kerfBegin() reads it, so that no compiler knows

void kerfNever(const in uint site) {
    if (kerfZero == 12345u) kerfNote(4u, site, 0u, 0u);
}

// --- bounds --------------------------------------------------------------------------------------

void kerfCheck(const in uint index, const in uint count, const in uint site) {
    if (index >= count) kerfNote(1u, site, index, count);
}

// --- races: who read and wrote a word last -------------------------------------------------------
// Two invocations of a launch that come to a word, of which one writes, must be told apart by a
// barrier of their group, or both be atomic. Groups can't be told apart, unless the block is
// coherent, where one group may read what another wrote (and counted), and all what is changed
// atomically.

const uint kerfReads = 1u;
const uint kerfWrites = 2u;
const uint kerfAtomic = 3u;
const uint kerfMany = 3u;  // of the last reader of a word: others read it too

uint kerfEpoch = 0u;  // barriers passed

uint kerfTag(const in uint how) {
    return how | (kerfEpoch & 2047u) << 2 | (gl_LocalInvocationIndex & 511u) << 13 |
           (gl_WorkGroupID.x & 1023u) << 22;
}

bool kerfMeets(const in uint own, const in uint other, const in bool groupsOrdered,
               const in bool isCoherent) {
    if (other == 0u || (own >> 13) == (other >> 13)) return false;  // nobody, or itself
    if ((own & other & 3u) == kerfAtomic) return false;
    bool isRead = (own & 3u) == kerfReads || (other & 3u) == kerfReads;
    bool isAtomic = (own & 3u) == kerfAtomic || (other & 3u) == kerfAtomic;
    if (isCoherent && isRead && isAtomic) return false;
    if ((own >> 22) == (other >> 22)) return (own & 0x1ffcu) == (other & 0x1ffcu);
    return !groupsOrdered;
}

// What this invocation came to since the last barrier: x: word, words there less 1 << 24, how << 26,
// coherent << 28; y: line, shared or binding << 24. Looked at in one place, which compiles faster.
const uint kerfQueueSize = 4096u;
uvec2 kerfQueue[kerfQueueSize];
uint kerfQueued = 0u;

// Which epochs are watched in a launch of one group. Its loops are long, and llvmpipe ends them after
// 65,535 turns in all.
const uint kerfMostTurns = 1000u;
uint kerfSlice = 0u;
uint kerfTurns = 0u;

void kerfTouch(const in uint first, const in uint how, const in uint site) {
    uint slice = kerfEpoch * 0x85ebca6bu >> 24;
    if (gl_NumWorkGroups.x == 1u && slice != kerfSlice) return;
    if (kerfQueued < kerfQueueSize) kerfQueue[kerfQueued] = uvec2((first & 0xffffffu) | how, site);
    ++kerfQueued;
}

void kerfTouchWord(const in int shadow, const in uint tag, const in bool isShared,
                   const in bool isCoherent, const in uint site) {
    bool reads = (tag & 3u) == kerfReads;
    uint before = imageAtomicExchange(kerfWatch, reads ? shadow + 1 : shadow, tag);
    uint there = imageLoad(kerfWatch, reads ? shadow : shadow + 1).x;
    // Of readers the last is kept, and whether there are others: of another group none in shared
    // memory, which has the same words for each sixteenth.
    bool sameGroup = (before >> 22) == (tag >> 22);
    bool atOnce = sameGroup ? (before & 0x1ffcu) == (tag & 0x1ffcu) : !isShared;
    bool another = (before >> 13) != (tag >> 13) || (before & 3u) == kerfMany;
    if (reads && before != 0u && atOnce && another) imageAtomicOr(kerfWatch, shadow + 1, kerfMany);
    uint writer = reads ? there : before;
    uint reader = reads || there == 0u ? 0u : (there & ~3u) | kerfReads;
    if (!reads && (there & 3u) == kerfMany && (there >> 13) == (tag >> 13)) reader ^= 1u << 13;
    if (kerfMeets(tag, writer, isShared || (isCoherent && reads), isCoherent)) {
        kerfNote(2u, site, tag, writer);
    }
    if (kerfMeets(tag, reader, isShared || isCoherent, isCoherent)) kerfNote(2u, site, tag, reader);
}

void kerfSettle() {
    uint most = gl_NumWorkGroups.x == 1u ? kerfMostTurns - kerfTurns : kerfQueueSize;
    for (uint i = 0u; i < min(kerfQueued, most); ++i) {
        uvec2 entry = kerfQueue[i];
        uint binding = entry.y >> 24;
        bool isShared = binding == kerfSharedBinding;
        uint slot = kerfShared + 2u * kerfSharedWords * (gl_WorkGroupID.x % kerfSharedSlots);
        uint base = isShared ? slot : imageLoad(kerfWatch, int(kerfBases + binding)).x;
        uint stride = isShared ? 1u : imageLoad(kerfWatch, int(kerfStrides + binding)).x;
        uint words = stride * (((entry.x >> 24) & 3u) + 1u);
        for (uint w = 0u; base != 0u && w < words; ++w) {
            kerfTouchWord(int(base + 2u * (stride * (entry.x & 0xffffffu) + w)),
                          kerfTag((entry.x >> 26) & 3u), isShared, (entry.x >> 28) != 0u,
                          entry.y & 0xffffffu);
        }
        kerfTurns += words + 1u;
        if (gl_NumWorkGroups.x == 1u && kerfTurns + 8u > kerfMostTurns) break;
    }
    if (gl_NumWorkGroups.x > 1u && kerfQueued > kerfQueueSize) kerfNote(5u, 0u, kerfQueued, 0u);
    kerfQueued = 0u;
}

void kerfPass() { ++kerfEpoch; }

// --- around the kernel ---------------------------------------------------------------------------

void kerfBegin() {
    kerfZero = imageLoad(kerfWatch, 1).x;
    kerfSlice = imageLoad(kerfWatch, 2).x;
}
