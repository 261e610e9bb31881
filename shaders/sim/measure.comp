// What the CPU wants to know after a step: volume, boxes of positions, velocities and ways since
// the last search for contacts, energy and whether a vertex is lost (not finite, or faster than
// anything real), per block; behind the blocks, how many contacts there were and how many points
// had candidates for them; and which vertices have a triangle near the blade. Reads X, velocities,
// rest positions, neighbours, places, pages, pieces, blocks, the state of contact, the query,
// constraints. Writes block measures and records of nearby vertices. One group of SUM_GROUP threads
// per block; sums in a fixed order (see volume_gradient). The CPU reads the result.
#include "constraints.h"
#include "contact_records.h"
#include "unfold_records.h"
#include "sim/base/fetch.glsl"
#include "sim/base/ordered_floats.glsl"
#include "sim/base/uniforms.glsl"
layout(local_size_x = SUM_GROUP) in;
const uint kSumGroup = SUM_GROUP;
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
STATE_TEXELS(kUnfoldRestBinding) restPositions;
RECORD_PAIRS(kRangesBinding) ranges;
RECORD_PAIRS(kEntriesBinding) neighbours;
RECORD_WORDS(kPlacesBinding) places;
layout(std430, binding = kPagesBinding) readonly buffer Pages { uint pages[]; };
layout(std430, binding = kPiecesBinding) readonly buffer Pieces { PieceRecord pieces[]; };
layout(std430, binding = kBlocksBinding) readonly buffer Blocks { BlockRecord blocks[]; };
layout(std430, binding = kContactCountsOfStepBinding) readonly buffer Contacts {
    ContactState contacts;
};
layout(std430, binding = kSearchedBinding) readonly buffer Searched { vec4 searched[]; };
layout(std430, binding = kBlockSumsBinding) writeonly buffer Measures { BlockMeasure measures[]; };

layout(std430, binding = kNearbyBinding) buffer Nearby {
    NearbyQuery query;
    NearbyVertex nearby[];
};

shared vec4 lows[kGroupSize];
shared vec4 highs[kGroupSize];
shared vec4 slowest[kGroupSize];
shared vec4 fastest[kGroupSize];
shared vec4 leastWay[kGroupSize];  // w: energy of strained material
shared vec4 mostWay[kGroupSize];  // w: largest fold

vec4 positionOf(uint v) { return fetch(positions, v); }
uint neighbourAt(uint place) {
    uvec2 pair = fetch(neighbours, place / 2u).xy;
    return (place & 1u) == 0u ? pair.x : pair.y;
}

// Kernels that solve constraints have more.
vec4 displacementOf(uint v) { return vec4(0.0); }
void setCorrection(uint index, vec4 pull) {}

// Energy of strained material at X [J]: that of each constraint, and beyond the clamp of a bend
// what its constant moment adds. What is off holds none.
RECORD_PAIRS(kAllRangesUnit) edgeRanges;
RECORD_QUADS(kAllEntriesUnit) spokes;
#define DECLARE(number, Name, list, Constraint, Gather) \
    RECORD_QUADS(kAllRecordsUnit + 3u * number) list##Records;
KERF_PULLING(DECLARE)
#undef DECLARE

#include "sim/constraints.glsl"
#include "sim/base/folded.glsl"

float largestStretch = 0.0;  // of the edges that this thread has summed up

float edgeEnergy(uint v) {
    vec4 own = fetch(positions, v);
    uvec2 range = fetch(edgeRanges, v).xy;
    float sum = 0.0;
    for (uint k = range.x; k < range.y; ++k) {
        Spoke spoke = fetchSpoke(spokes, k);
        vec4 far = fetch(positions, spoke.other);
        float error = distance(own.xyz, far.xyz) - spoke.rest_length;
        sum += energyOf(error * error, spoke.geometry, kStretch, own.w + far.w);
        float stretch = min(error / max(spoke.rest_length, uniforms.gravity.w), kMostStretch);
        if (stretch > largestStretch) largestStretch = stretch;  // no comparison holds for NaN
    }
    return 0.5 * sum;  // the other end has the other half
}

float largestFold = 0.0;  // of the bends that this thread has summed up

float energyOfBend(BendRecord bend) {
    vec4 x0 = fetch(positions, bend.v0);
    vec4 x1 = fetch(positions, bend.v1);
    vec4 x2 = fetch(positions, bend.v2);
    vec4 x3 = fetch(positions, bend.v3);
    Wings wings = wingsOf((x1 - x0).xyz, (x2 - x0).xyz, (x3 - x0).xyz);
    largestFold = max(largestFold, foldOf(wings, bend));
    if (degenerate(wings)) return 0.0;
    vec2 turn = errorVector(wings, bend);
    float error = abs(inverseTangent(turn.y, turn.x));
    float elastic = min(error, kMaxBendError);
    // Of the apexes alone, which turn it most.
    float e2 = dot(wings.edge, wings.edge);
    float moved = e2 * (x2.w / dot(wings.nA, wings.nA) + x3.w / dot(wings.nB, wings.nB));
    return energyOf(elastic * (2.0 * error - elastic), bend.geometry, kBend, moved);
}

uint countIf(uint part, uint count) {
    return (uniforms.active_parts & part) != 0u ? count : 0u;
}

// What thread `first` of `stride` threads sums up, always in the same order.
float strainEnergy(uint first, uint stride) {
    float sum = 0.0;
    uint edgeVertices = countIf(kStretchPart, uniforms.vertex_count);
    for (uint v = first; v < edgeVertices; v += stride) sum += edgeEnergy(v);
#define SUM_UP(number, Name, list, Constraint, Gather)                        \
    uint list##Count = countIf(k##Name##Part, uniforms.count[number]);        \
    for (uint i = first; i < list##Count; i += stride) {                      \
        sum += energyOf##Name(fetch##Name(list##Records, i));                 \
    }
    KERF_PULLING(SUM_UP)
#undef SUM_UP
    return sum;
}

// dV/dp of a vertex: a sixth of the sum of (p_j - p) x (p_k - p) over its triangles. Around a
// closed umbrella this equals the gradient about any origin, and it is small and exact in floats.
// Where triangles are absent it is that of the others about the vertex, and the sum of a third of
// (p - origin) . dV/dp still their exact volume about the origin. Neighbours lie
// counter-clockwise around each vertex, with kAfterGap.
// Six times the gradient, of the vertex at x with neighbours at `range`.
vec3 sixfoldGradient(vec3 x, uvec2 range) {
    vec3 sum = vec3(0.0);
    vec3 last = positionOf(neighbourAt(range.y - 1u) & ~kAfterGap).xyz - x;
    for (uint k = range.x; k < range.y; ++k) {
        uint corner = neighbourAt(k);
        vec3 next = positionOf(corner & ~kAfterGap).xyz - x;
        sum += (corner & kAfterGap) == 0u ? cross(last, next) : vec3(0.0);
        last = next;
    }
    return sum;
}

// Kinetic, and potential about the floor (about 0 without one) [J]. What does not move by itself
// has no inverse mass and counts for nothing.
vec2 energyOf(vec4 position, vec3 velocity) {
    if (position.w <= 0.0) return vec2(0.0);
    float mass = 1.0 / (position.w * uniforms.inverse_density);
    bool hasFloor = (uniforms.active_parts & kFloorPart) != 0u;
    vec3 above = position.xyz - vec3(0.0, hasFloor ? uniforms.floor_height : 0.0, 0.0);
    return mass * vec2(0.5 * dot(velocity, velocity), -dot(uniforms.gravity.xyz, above));
}

bool lost(vec3 position, vec3 velocity) {
    return !within(position, 1e10) || !within(velocity, uniforms.runaway_speed);
}

// The box of a vertex and its neighbours holds all triangles at it. Rounding is the asker's
// business.
bool meetsQuery(vec3 low, vec3 high) {
    vec3 way = 0.5 * (low + high) - query.center.xyz;
    vec3 reach = 0.5 * (high - low);
    vec3 along = abs(vec3(dot(query.first_axis.xyz, way), dot(query.second_axis.xyz, way),
                          dot(query.third_axis.xyz, way)));
    vec3 most = vec3(query.first_axis.w + dot(abs(query.first_axis.xyz), reach),
                     query.second_axis.w + dot(abs(query.second_axis.xyz), reach),
                     query.third_axis.w + dot(abs(query.third_axis.xyz), reach));
    return all(lessThanEqual(along, most));
}

void lookForNearby(uint v, vec3 p, vec3 u) {
    uvec2 range = fetch(ranges, v).xy;
    uint end = query.asks_for_box != 0u ? range.y : range.x;
    vec3 low = p;
    vec3 high = p;
    for (uint k = range.x; k < end; ++k) {
        vec3 q = positionOf(neighbourAt(k) & ~kAfterGap).xyz;
        low = min(low, q);
        high = max(high, q);
    }
    if (end > range.x && meetsQuery(low, high)) {
        uint record = atomicAdd(query.count, 1u);
        if (record < query.capacity) {
            nearby[record] = NearbyVertex(v, p.x, p.y, p.z, u.x, u.y, u.z, 0u);
        }
    }
}

// Of the place `self` of all pages of a block, and of constraints.
void measurePlace(BlockRecord block, vec3 origin, uint self) {
    vec4 low = vec4(vec3(1e30), 0.0);
    vec4 high = vec4(vec3(-1e30), 0.0);
    vec4 slow = vec4(vec3(1e30), 0.0);
    vec4 fast = vec4(vec3(-1e30), 0.0);
    vec3 least = vec3(1e30);
    vec3 most = vec3(-1e30);
    for (uint i = 0u; i < block.page_count; ++i) {
        uint v = fetch(places, kPageSize * pages[block.first_page + i] + self).x;
        if (v == kNoVertex) continue;
        vec4 x = fetch(positions, v);
        vec3 p = x.xyz;
        vec3 arm = p - origin;
        low = vec4(min(low.xyz, p),
                   low.w + dot(arm, sixfoldGradient(p, fetch(ranges, v).xy)) / 18.0);
        vec3 u = fetch(velocities, v).xyz;
        high = vec4(max(high.xyz, p), lost(p, u) ? kLostStretch : high.w);
        vec2 energy = energyOf(x, u);
        slow = vec4(min(slow.xyz, u), slow.w + energy.x);
        fast = vec4(max(fast.xyz, u), fast.w + energy.y);
        vec3 way = p - searched[v].xyz;
        lookForNearby(v, p, u);
        least = min(least, way);
        most = max(most, way);
    }
    lows[self] = low;
    slowest[self] = slow;
    fastest[self] = fast;
    largestFold = 0.0;
    largestStretch = 0.0;
    leastWay[self] = vec4(least, strainEnergy(kGroupSize * gl_WorkGroupID.x + self,
                                              kGroupSize * gl_NumWorkGroups.x));
    mostWay[self] = vec4(most, largestFold);
    highs[self] = vec4(high.xyz, max(high.w, largestStretch));
}

void join(uint self, uint other) {
    lows[self] = vec4(min(lows[self].xyz, lows[other].xyz), lows[self].w + lows[other].w);
    highs[self] = max(highs[self], highs[other]);
    slowest[self] =
        vec4(min(slowest[self].xyz, slowest[other].xyz), slowest[self].w + slowest[other].w);
    fastest[self] =
        vec4(max(fastest[self].xyz, fastest[other].xyz), fastest[self].w + fastest[other].w);
    leastWay[self] =
        vec4(min(leastWay[self].xyz, leastWay[other].xyz), leastWay[self].w + leastWay[other].w);
    mostWay[self] = max(mostWay[self], mostWay[other]);
}

void main() {
    BlockRecord block = blocks[gl_WorkGroupID.x];
    vec3 origin = fetch(positions, pieces[block.piece].origin).xyz;
    uint self = gl_LocalInvocationID.x;
    for (uint place = self; place < kPageSize; place += kSumGroup) {
        measurePlace(block, origin, place);
    }
    for (uint reach = kPageSize / 2u; reach > 0u; reach /= 2u) {
        barrier();
        for (uint i = self; i < reach; i += kSumGroup) join(i, i + reach);
    }
    if (self == 0u && gl_WorkGroupID.x == 0u) {
        vec4 counts = vec4(contacts.last_contacts, contacts.points, 0.0, 0.0);
        measures[gl_NumWorkGroups.x] =
            BlockMeasure(counts, vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    }
    if (self == 0u) {
        measures[gl_WorkGroupID.x] =
            BlockMeasure(lows[0], highs[0], slowest[0], fastest[0], leastWay[0], mostWay[0]);
    }
}
