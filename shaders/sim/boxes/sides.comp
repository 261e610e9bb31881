// Keeps vertices behind the planes between their triangles and boxes, whatever has moved them since
// the substep began: of what is too much X gives way first, so that nothing is shot off, then d.
// Where planes leave no room between them the whole way is shortened, which keeps behind all of
// them. Reads X at the beginning of the substep, planes, triangles around each vertex. Reads and
// writes X and d, clears shares. With OF_STEP, after an implicit step of X (numbers: its length,
// float bits [s]), X gives way, and the velocity with it. One thread per vertex. A storage barrier
// follows.
#include "bindings.h"
#include "blade_records.h"
#include "sim/base/numbers.glsl"
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) buffer Positions { vec4 positions[]; };
#ifdef OF_STEP
layout(std430, binding = kVelocitiesBinding) buffer Velocities { vec4 velocities[]; };
#else
layout(std430, binding = kBoxDisplacementBinding) buffer Displacement { vec4 displacement[]; };
#endif
layout(std430, binding = kBoxRecordsBinding) readonly buffer Planes { BoxPlanes planes[]; };
layout(std430, binding = kBoxSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kBladeRangesBinding) readonly buffer Ranges { IncidenceRange ranges[]; };
layout(std430, binding = kBladeIncidenceBinding) readonly buffer Incidence { uint incidence[]; };
layout(std430, binding = kBoxStartBinding) readonly buffer Start { vec4 start[]; };

const int kRounds = 3;

// Since the substep began.
struct Way {
    vec3 push;  // of X [m]
    vec3 d;
};

BoxPlanes planesOf(uint entry) {
    BoxPlanes near = planes[incidence[entry] / 4u];
    if (near.first.w < kNoPlane) return near;
    return BoxPlanes(vec4(kNoPlane), vec4(kNoPlane), vec4(kNoPlane));
}

float tooFar(Way way, vec4 plane) { return -dot(plane.xyz, way.push + way.d) - plane.w; }

Way behind(Way way, vec4 plane) {
    float over = max(tooFar(way, plane), 0.0);
    float ofPush = min(over, max(-dot(plane.xyz, way.push), 0.0));
    return Way(way.push + ofPush * plane.xyz, way.d + (over - ofPush) * plane.xyz);
}

Way behindAll(Way way, IncidenceRange range) {
    for (uint k = range.first; k < range.end; ++k) {
        BoxPlanes near = planesOf(k);
        way = behind(behind(behind(way, near.first), near.second), near.third);
    }
    return way;
}

// The share of the way that keeps behind a plane; what rounding takes does not count.
float shareOf(Way way, vec4 plane) {
    float over = tooFar(way, plane);
    return over > 1e-7 ? plane.w / (plane.w + over) : 1.0;
}

float shareOfAll(Way way, IncidenceRange range) {
    float share = 1.0;
    for (uint k = range.first; k < range.end; ++k) {
        BoxPlanes near = planesOf(k);
        share = min(share, min(shareOf(way, near.first),
                               min(shareOf(way, near.second), shareOf(way, near.third))));
    }
    return share;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= obstacle.vertex_count || shares[v] == 0u) return;
    shares[v] = 0u;
    IncidenceRange range = ranges[v];
    vec3 x = start[v].xyz;
    vec4 now = positions[v];
#ifdef OF_STEP
    if (now.w == 0.0) return;
    Way way = Way(now.xyz - x, vec3(0.0));
#else
    Way way = Way(now.xyz - x, displacement[v].xyz);
#endif
    Way before = way;
    for (int i = 0; i < kRounds; ++i) way = behindAll(way, range);
    float share = shareOfAll(way, range);
    way = Way(share * way.push, share * way.d);
    // Not x + push where X stays: its bits stay.
    if (way.push != before.push) positions[v] = vec4(x + way.push, now.w);
#ifdef OF_STEP
    velocities[v].xyz += (way.push - before.push) / uintBitsToFloat(numbers.x);
#else
    displacement[v] = vec4(way.d, 0.0);
#endif
}
