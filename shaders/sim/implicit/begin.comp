// Begins a stage: where the body would be without forces, and the forces that it starts with:
//   p = from + s speed - X,  r = M (p / s^2 + g) + F - A (way of what is held)
// The first stage goes from X at the speed of the body; the second, with OF_SECOND, from where the
// first one's speed leads in the rest of the step, at a speed that its acceleration leads to.
// Contacts begin where the step does, with friction by the push of the stage before.
// Numbers: the slot of what the first stage left, the first row of an edge that presses, 0: none.
// One group for each aggregate. A storage barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
STATE_TEXELS(kPositionsBinding) positions;
STATE_TEXELS(kVelocitiesBinding) velocities;
STATE_TEXELS(kForceBinding) force;
STATE_TEXELS(kWayBinding) ways;
STATE_TEXELS(kDriftUnit) drift;
RECORD_QUADS(kAggregatesUnit) aggregates;
RECORD_QUADS(kMembersUnit) members;
#include "sim/implicit/contact_rows.glsl"
STATE_TEXELS(kRowStatesUnit) states;
layout(std430, binding = kResidualBinding) writeonly buffer Residuals { vec4 newResiduals[]; };
layout(std430, binding = kDirectionBinding) writeonly buffer Directions { vec4 newDirections[]; };
layout(std430, binding = kFirstWayBinding) writeonly buffer FirstWays { vec4 firstWays[]; };
layout(std430, binding = kRowStatesBinding) writeonly buffer States { vec4 newStates[]; };

#ifdef OF_SECOND
vec3 shift;
float done = 1.0;  // of the step, when the stage ends
void prepare(uint piece) { shift = balancingShift(piece); }

float lastPush(uint row) { return fetch(states, 2u * row + 1u).y; }
float leadsTo(uint row, float gap) {
    float from = gap + (implicit.rest / implicit.stage) * (fetch(states, 2u * row).w - gap);
    return lastPush(row) > 0.0 ? max(from, 0.0) : kUndamped;
}
vec3 freeWay(uint v) {
    vec3 way = fetch(ways, v).xyz + shift;
    firstWays[v] = vec4(way, 0.0);
    vec3 speed = way / implicit.stage;
    vec3 before = fetch(velocities, v).xyz;
    vec3 now = before + (implicit.rest / implicit.stage) * (speed - before);
    return implicit.rest * speed + implicit.stage * now;
}
#else
float done = implicit.stage / implicit.step;
void prepare(uint piece) {}
float lastPush(uint row) { return max(fetch(rows, kRowTexels * row + 3u).w, 0.0); }
float leadsTo(uint row, float gap) { return kUndamped; }
vec3 freeWay(uint v) { return implicit.stage * fetch(velocities, v).xyz; }
#endif

void beginRow(uint row) {
    ContactRow contact = rowAt(row);
    for (uint once = contact.slip.w > 0.0 ? 1u : 0u; once > 0u; --once) {
        float last = lastPush(row);
        float grip = contact.lead.w < 0.0 ? -1.0 : implicit.contact.friction * last;
        vec3 led = done * contact.lead.xyz;
        float away = dot(contact.normal.xyz, led);
        float from = leadsTo(row, contact.normal.w);
        newStates[2u * row] = vec4(contact.slip.xyz - (led - away * contact.normal.xyz),
                                   contact.normal.w - away);
        newStates[2u * row + 1u] = vec4(grip, 0.0, last, from);
    }
}

void main() {
    uvec4 own = fetch(aggregates, gl_WorkGroupID.x);  // ImplicitAggregate
    prepare(own.z);
    for (uint k = own.x + gl_LocalInvocationID.x; k < own.y; k += GROUP) {
        uint v = fetch(members, k).x;
        float inverseUnitMass = fetch(positions, v).w;
        bool held = !(inverseUnitMass > 0.0);
        vec3 way = held ? vec3(0.0) : freeWay(v);
        float mass = held ? 0.0 : massOf(inverseUnitMass);
        vec3 forces = mass * (implicit.inertia * way + implicit.gravity.xyz) + fetch(force, v).xyz -
            done * fetch(drift, v).xyz;
        newDirections[v] = vec4(way, 0.0);
        newResiduals[v] = vec4(held ? vec3(0.0) : forces, 0.0);
        for (uint k = 0u; k < kRowsOfVertex; ++k) beginRow(kRowsOfVertex * v + k);
        if (numbers.y != 0u) beginRow(numbers.y + v);
    }
}
