// Substeps of a small body by one work group: the phases of the other kernels in their order, with
// their arithmetic, and with sums in their order whatever the size of the group, so the bits are
// theirs. A substep begins with the prediction and ends with floor and velocities; with COLLIDES
// contact stands before its end, with MEETS_BOXES that with boxes too, and with UNFOLDS the springs
// that unfold before its beginning. Else what may move vertices in between (contact, boxes) stands
// between two dispatches, of which the first one leaves its last substep open.
// With PLAIN_PBD it is some of the sweeps of plain PBD instead, which meets nothing but the floor
// here. Reads links, lists, pulls, pieces, blocks, pages, places, with COLLIDES what contact reads.
// Reads and writes X, velocities, d, the state of contact. Corrections, gradients, parts, block
// sums, impulses, folds, records and sums are scratch. One group in all. A storage barrier follows.
#include "box_records.h"
#include "constraints.h"
#include "small_body_bindings.h"
#include "unfold_records.h"
const uint kSmallGroup = SMALL_GROUP;
layout(local_size_x = SMALL_GROUP) in;

#include "sim/fetch.glsl"
#include "sim/uniforms.glsl"

#include "sim/numbers.glsl"

#ifdef PLAIN_PBD
uint firstSweep = numbers.x;
uint endSweep = numbers.y;
#else
uint begins = numbers.x;            // substeps
bool endsFirst = numbers.y != 0u;  // a substep is open; it ends first
bool endsLast = numbers.z == 0u;   // else the last one stays open
uint blocksInAll = numbers.w;
#endif

RECORD_QUADS(kSmallLinksUnit) links;
RECORD_PAIRS(kAllRangesUnit) edgeRanges;
RECORD_QUADS(kAllEntriesUnit) spokes;
#define DECLARE(number, Name, list, Constraint, Gather)              \
    RECORD_QUADS(kAllRecordsUnit + 3u * number) list##Records;       \
    RANGES_OF_##Gather(kAllRangesUnit + 3u * number) list##Ranges;   \
    ENTRIES_OF_##Gather(kAllEntriesUnit + 3u * number) list##Entries;
KERF_PULLING(DECLARE)
#undef DECLARE
RECORD_PAIRS(kSmallNeighbourRangesUnit) neighbourRanges;
RECORD_PAIRS(kSmallNeighboursUnit) neighbours;
RECORD_WORDS(kSmallPlacesUnit) places;
STATE_TEXELS(kSmallRestUnit) restPositions;
layout(std430, binding = kSmallPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
RECORD_WORDS(kSmallBlocksUnit) blocks;
RECORD_WORDS(kSmallPagesUnit) pages;
RECORD_QUADS(kSmallPullsUnit) pulls;
layout(std430, binding = kSmallImpulsesBinding) coherent buffer Impulses {
    VolumeImpulse impulses[];
};

#include "sim/small_body_state.glsl"

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
// Open pieces have no volume constraint, so gaps do not matter here.
uvec2 neighboursAt(uint pair) { return fetch(neighbours, pair).xy & ~kAfterGap; }
uvec2 rangeAt(uint v) { return fetch(neighbourRanges, v).xy; }
uint placeAt(uint place) { return fetch(places, place).x; }
float impulseFor(uint piece) { return impulses[piece].impulse; }
uint pieceOf(uint v) { return fetch(links, v).w; }

VolumeSum sumOfBlock(uint block);

#include "sim/constraints.glsl"
#include "sim/gather.glsl"
#include "sim/mass_split.glsl"
#include "sim/pull.glsl"
#include "sim/settle.glsl"
#include "sim/stretch.glsl"
#include "sim/volume_gradient.glsl"
#ifdef COLLIDES
#include "sim/contact/answers.glsl"
#ifdef MEETS_BOXES
#include "sim/boxes/keep_out.glsl"
#include "sim/boxes/touches.glsl"
#endif
#ifdef UNFOLDS
#include "sim/unfold/fold_sums.glsl"
#include "sim/unfold/folded.glsl"
#include "sim/unfold/goals.glsl"
#include "sim/unfold/pulls.glsl"
#include "sim/unfold/raise_folds.glsl"
#endif
#endif

// The last part of the sum that volume_gradient has.
VolumeSum sumOfBlock(uint block) {
    vec2 sum = partAt(kGroupSize * block);
    for (uint i = 1u; i < kSumRows; ++i) sum += partAt(kGroupSize * block + i);
    return VolumeSum(sum.x, sum.y);
}

uint self = gl_LocalInvocationID.x;
#define FOR_EACH_OWN(i, count) for (uint i = firstOf(count); i < endOf(count); i += kStride)

bool isActive(uint part) {
    return (uniforms.active_parts & part) != 0u;
}

#ifdef PLAIN_PBD
vec3 startOf(uint v, float inverseUnitMass) {
    return sweptOf(v);
}

void predict() {
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        setSwept(v, predicted(velocityOf(v).xyz, positionOf(v).w));
    }
    endPhase();
}
#else
vec3 startOf(uint v, float inverseUnitMass) {
    return predicted(velocityOf(v).xyz, inverseUnitMass);
}
#endif

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

void end(uint v, vec3 d, vec4 x) {
    if (isActive(kFloorPart)) d = onFloor(d, x, foldAt(v));
    if (x.w > 0.0) setVelocity(v, endVelocity(d));
    setPosition(v, vec4(x.xyz + d, x.w));
}

#ifdef PLAIN_PBD
void finishSweep(bool last) {
    bool lifts = isActive(kFloorPart);
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        vec4 x = positionOf(v);
        vec3 d = displacementOf(v).xyz;
        KERF_PULLING_LAST(GATHER_IF_ON)
        if (last) {
            setDisplacement(v, vec4(d, 0.0));
            end(v, d, x);
        } else {
            setSwept(v, lifts ? onFloor(d, x, foldAt(v)) : d);
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
    storeDisplacements(self);
}
#else
BlockRecord blockAt(uint b) {
    return BlockRecord(fetch(blocks, 3u * b).x, fetch(blocks, 3u * b + 1u).x,
                       fetch(blocks, 3u * b + 2u).x);
}

// A block of a small body is one page.
void sumPlaces() {
    for (uint b = 0u; b < blocksInAll; ++b) {
        BlockRecord block = blockAt(b);
        uint firstPlace = kPageSize * fetch(pages, block.first_page).x;
        uint origin = pieces[block.piece].origin;
        vec3 originX = positionOf(origin).xyz;
        vec3 originD = displacementOf(origin).xyz;
        for (uint place = self; place < kPageSize; place += kSmallGroup) {
            setPart(kGroupSize * b + place, sumAt(firstPlace + place, originX, originD));
        }
    }
    endPhase();
}

// As volume_gradient has it.
void sumRows() {
    for (uint i = self; i < kSumRows * blocksInAll; i += kSmallGroup) {
        uint end = kGroupSize * (i / kSumRows + 1u);
        uint row = kGroupSize * (i / kSumRows) + i % kSumRows;
        vec2 sum = partAt(row);
        for (uint place = row + kSumRows; place < end; place += kSumRows) sum += partAt(place);
        setPart(row, sum);
    }
    endPhase();
}

void sumVolume() {
    sumPlaces();
    sumRows();
    for (uint p = self; p < uniforms.piece_count; p += kSmallGroup) {
        impulses[p] = VolumeImpulse(impulseOver(pieces[p]), 0u);
    }
    endPhase();
}

// What concerns each vertex alone.
void settle(bool corrects, bool ends) {
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        vec4 x = positionOf(v);
        vec3 d = displacementOf(v).xyz;
        if (corrects) d = heldByVolume(v, d, x.w);
        if (ends) {
            end(v, d, x);
        } else {
            setDisplacement(v, vec4(d, 0.0));
        }
    }
    endPhase();
}

PullRecord pullOf(uvec4 first, uvec4 second) {
    vec3 target = uintBitsToFloat(first.yzw);
    vec3 motion = uintBitsToFloat(second.xyz);
    return PullRecord(first.x, target.x, target.y, target.z, motion.x, motion.y, motion.z,
                      second.w);
}

void pullAll() {
    FOR_EACH_OWN(i, uniforms.pull_count) {
        pullBy(pullOf(fetch(pulls, 2u * i), fetch(pulls, 2u * i + 1u)));
    }
    endPhase();
}

#if defined(COLLIDES) && defined(UNFOLDS)
void unfoldAll() {
    FOR_EACH_OWN(v, uniforms.vertex_count) forgetFold(v);
    endPhase();
    FOR_EACH_OWN(i, uniforms.count[kBend]) raiseFolds(fetchBend(bendsRecords, i));
    endPhase();
    FOR_EACH_OWN(v, uniforms.vertex_count) setFoldSum(v, sumOfFolds(v, rangeAt(v)));
    endPhase();
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        for (uint once = floatBitsToUint(foldAt(v)) != 0u ? 1u : 0u; once > 0u; --once) {
            setGoal(v, goalOf(v, rangeAt(v)));
        }
    }
    endPhase();
    FOR_EACH_OWN(v, uniforms.vertex_count) unfold(v, rangeAt(v));
    endPhase();
}
#else
void unfoldAll() {}
#endif

#ifdef COLLIDES
void touch() {
    uint count = state.points;
    if (count == 0u) return;
    FOR_EACH_OWN(i, count) {
        detectPoint(i);
        detectEdges(i);
    }
    endPhase();
    FOR_EACH_OWN(i, count) respondAt(i, false);
    endPhase();
    FOR_EACH_OWN(i, count) respondAt(i, true);
    endPhase();
    FOR_EACH_OWN(v, uniforms.vertex_count) applyTo(v);
    endPhase();
    if (self == 0u) endContacts();
}

#ifdef MEETS_BOXES
void meetBoxes() {
    FOR_EACH_OWN(i, obstacle.triangle_count) touchTriangle(i);
    endPhase();
    FOR_EACH_OWN(i, obstacle.triangle_count) respondTriangle(i);
    endPhase();
    FOR_EACH_OWN(v, uniforms.vertex_count) applyTouches(v);
    endPhase();
    FOR_EACH_OWN(v, uniforms.vertex_count) {
        if (positionOf(v).w != 0.0) setDisplacement(v, vec4(outOfBoxes(v), 0.0));
    }
    endPhase();
}
#else
void meetBoxes() {}
#endif

// Contact comes once everything else has moved d.
void substep(bool ends) {
    unfoldAll();
    stretchAll();
    KERF_PULLING(SOLVE_IF_ON)
    if (isActive(kVolumePart)) {
        sumVolume();
        settle(true, false);
    }
    if (uniforms.pull_count > 0u) pullAll();
    touch();
    meetBoxes();
    settle(false, true);
}
#else
void substep(bool ends) {
    bool volume = isActive(kVolumePart);
    stretchAll();
    KERF_PULLING(SOLVE_IF_ON)
    if (volume) sumVolume();
    if (uniforms.pull_count == 0u) {
        if (volume || ends) settle(volume, ends);
        return;
    }
    if (volume) settle(true, false);
    pullAll();
    if (ends) settle(false, true);
}
#endif

void main() {
    loadDisplacements(self);
    endPhase();
    if (endsFirst) settle(false, true);
    for (uint i = 0u; i < begins; ++i) {
        substep(endsLast || i + 1u < begins);
    }
    storeDisplacements(self);
}
#endif
