// Some of the sweeps of plain PBD over a body that meets nothing but the floor, by one work group:
// the phases of the other kernels in their order and with their arithmetic, so the bits are theirs.
// Reads links, lists. Reads and writes X, velocities, d. Corrections are scratch. One group in all.
// A storage barrier follows.
#include "constraints.h"
#include "sweep_bindings.h"
const uint kSweepGroup = SWEEP_GROUP;
layout(local_size_x = SWEEP_GROUP) in;

#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"

#include "sim/numbers.glsl"

uint firstSweep = numbers.x;
uint endSweep = numbers.y;

RECORD_QUADS(kSweepLinksUnit) links;
RECORD_PAIRS(kAllRangesUnit) edgeRanges;
RECORD_QUADS(kAllEntriesUnit) spokes;
#define DECLARE(number, Name, list, Constraint, Gather)              \
    RECORD_QUADS(kAllRecordsUnit + 3u * number) list##Records;       \
    RANGES_OF_##Gather(kAllRangesUnit + 3u * number) list##Ranges;   \
    ENTRIES_OF_##Gather(kAllEntriesUnit + 3u * number) list##Entries;
KERF_PULLING(DECLARE)
#undef DECLARE

#include "sim/sweep_state.glsl"

#define RANGE_OF(number, Name, list, Constraint, Gather) \
    if (type == number) return fetch(list##Ranges, v);
#define ENTRY_OF(number, Name, list, Constraint, Gather) \
    if (type == number) return fetch(list##Entries, index);
uvec4 rangeOfList(uint type, uint v) {
    KERF_PULLING(RANGE_OF)
    return uvec4(0u);
}
uvec4 entryOfList(uint type, uint index) {
    KERF_PULLING(ENTRY_OF)
    return uvec4(0u);
}
#undef RANGE_OF
#undef ENTRY_OF

Spoke spokeAt(uint place) { return fetchSpoke(spokes, place); }
vec3 startOf(uint v, float inverseUnitMass) { return sweptOf(v); }

#include "sim/constraints.glsl"
#include "sim/finish.glsl"
#include "sim/floor.glsl"
#include "sim/gather.glsl"
#include "sim/mass_split.glsl"
#include "sim/stretch.glsl"

#define FOR_EACH_OWN(i, count) for (uint i = firstOf(count); i < endOf(count); i += kStride)

bool isActive(uint part) {
    return (uniforms.active_parts & part) != 0u;
}

void predict() {
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        setSwept(v, predicted(velocityOf(v).xyz, positionOf(v).w));
    }
    endPhase();
}

void stretchAll() {
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        vec4 own = positionOf(v);
        setDisplacement(v, vec4(stretched(v, own, fetch(edgeRanges, v).xy),
                                splitFrom(kStretch + 1u, own.w, fetch(links, v))));
    }
    endPhase();
}

#define PHASES(number, Name, list, Constraint, Gather)                                        \
    void pullBy##Name() {                                                                     \
        FOR_EACH_OWN(i, uniforms.count[number]) {                                             \
            solve##Name(fetch##Name(list##Records, i), i);                                    \
        }                                                                                     \
        endPhase();                                                                           \
    }                                                                                         \
    vec3 after##Name(uint v, float inverseUnitMass) {                                         \
        vec3 sum = sumOf##Gather(number, v);                                                  \
        return withSum(displacementOf(v).xyz, inverseUnitMass, sum);                          \
    }                                                                                         \
    void solveAll##Name() {                                                                   \
        pullBy##Name();                                                                       \
        FOR_EACH_OWN(v, uniforms.vertex_count) {                                              \
            float inverseUnitMass = positionOf(v).w;                                          \
            float split = splitFrom(number + 1u, inverseUnitMass, fetch(links, v));           \
            setDisplacement(v, vec4(after##Name(v, inverseUnitMass), split));                 \
        }                                                                                     \
        endPhase();                                                                           \
    }
KERF_PULLING(PHASES)
#undef PHASES
#define SOLVE_IF_ON(number, Name, list, Constraint, Gather) \
    if (isActive(k##Name##Part)) solveAll##Name();
#define PULL_IF_ON(number, Name, list, Constraint, Gather) \
    if (isActive(k##Name##Part)) pullBy##Name();
#define GATHER_IF_ON(number, Name, list, Constraint, Gather) \
    if (isActive(k##Name##Part)) d = after##Name(v, x.w);

void endStep(uint v, vec3 d, vec4 x) {
    setDisplacement(v, vec4(d, 0.0));
    if (x.w > 0.0) setVelocity(v, endVelocity(d));
    setPosition(v, vec4(x.xyz + d, x.w));
}

void finishSweep(bool last) {
    bool lifts = isActive(kFloorPart);
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        vec4 x = positionOf(v);
        vec3 d = displacementOf(v).xyz;
        KERF_PULLING_LAST(GATHER_IF_ON)
        d = lifts ? onFloor(d, x) : d;
        if (last) {
            endStep(v, d, x);
        } else {
            setSwept(v, d);
        }
    }
    endPhase();
}

void sweep(bool last) {
    stretchAll();
    KERF_PULLING_FIRST(SOLVE_IF_ON)
    KERF_PULLING_LAST(PULL_IF_ON)
    finishSweep(last);
}

void main() {
    uint first = firstSweep;
    uint afterLast = endSweep;
    if (first == 0u) predict();
    for (uint i = first; i < afterLast; ++i) sweep(i + 1u == uniforms.sweeps);
    storeDisplacements();
}
