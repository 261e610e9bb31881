// How far pieces that touch each other go along their directions: to where that does most, which
// Newton's method finds, since the forces of contact have kinks. Then what the contacts push there.
// With OF_START that is from where a stage begins (start.glsl).
// Numbers: the slot; not 0: friction's bounds are renewed; not 0: it is the last iteration. One
// group for each piece, of which the first of those that touch works for all of them. A storage
// barrier follows.
#include "sim/base/numbers.glsl"
layout(local_size_x = GROUP) in;
#include "sim/implicit/scalars.glsl"
#include "sim/implicit/contact_rows.glsl"
STATE_TEXELS(kDirectionBinding) directions;
STATE_TEXELS(kPressureBinding) pressures;
RECORD_QUADS(kRowVerticesUnit) rowVertices;
RECORD_WORDS(kRowListUnit) rowList;
layout(std430, binding = kContactForcesBinding) buffer Forces { int sums[]; };
layout(std430, binding = kReachesBinding) coherent buffer Reaches { vec4 reaches[]; };
layout(std430, binding = kRelativeBinding) coherent buffer Relatives { vec4 relatives[]; };
layout(std430, binding = kRowStatesBinding) coherent buffer States { vec4 states[]; };
#ifdef LOAD_IMAGES  // storage is read lane by lane there
layout(binding = kRelativeUnit, rgba32f) coherent readonly uniform imageBuffer relativeTexels;
layout(binding = kRowStatesUnit, rgba32f) coherent readonly uniform imageBuffer stateTexels;
vec3 relativeAt(uint row) { return imageLoad(relativeTexels, int(row)).xyz; }
vec4 stateAt(uint at) { return imageLoad(stateTexels, int(at)); }
#else
vec3 relativeAt(uint row) { return relatives[row].xyz; }
vec4 stateAt(uint at) { return states[at]; }
#endif
#include "sim/base/fixed_sums.glsl"

// Of a piece: what is gained along the direction is slope * alpha - curve * alpha^2 / 2, and
// pressure.x - alpha * pressure.y of dV/dp is left in the residual.
struct Line {
    float curve;
    float slope;
    vec2 pressure;
    float missing;   // see Reach
    float swelling;
};

#ifdef OF_START
#include "sim/implicit/start.glsl"
#else
Line lineOf(uint index) {
    ImplicitPiece piece = pieceAt(index);
    vec4 product = sumOfProducts(piece, numbers.x).first;
    float pressure = ratio(product.y, knownOf(piece, numbers.x).z);
    return Line(product.x, product.w, vec2(0.0, pressure), 0.0, 0.0);
}
#endif

// The preconditioner knows the matrix better than by this factor. What seems to gain more goes
// along rounding, which what is left of pressure leaves in directions.
const float kMostGain = 10.0;

float mostGain(uint root) {
#ifdef OF_START
    return 1e30;
#else
    return kMostGain * knownOf(pieceAt(root), numbers.x).y;
#endif
}

// Of all pieces that touch this one.
struct Touching {
    uint root;
    uint row_count;
    float curve;
    float slope;
    float most;  // that may be gained: see mostGain()
};

// Leaves what a piece has to know later in the place of its reach.
Touching begin(uint root) {
    Touching all = Touching(root, 0u, 0.0, 0.0, mostGain(root));
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        Line line = lineOf(p);
        all.curve += line.curve;
        all.slope += line.slope;
        all.row_count += pieceAt(p).row_count;
        if (gl_LocalInvocationID.x == 0u) {
            reaches[p] = vec4(line.pressure, line.missing, line.swelling);
        }
    }
    return all;
}

void end(uint root, float alpha) {
    if (gl_LocalInvocationID.x != 0u) return;
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        vec4 line = reaches[p];
        reaches[p] = vec4(alpha, line.x - alpha * line.y, line.zw);
    }
}

uint rowOf(uint p, uint k) {
    return fetch(rowList, kRowsOfPage * pieceAt(p).first_page + k).x;
}

#ifdef OF_START
// Along the motion, and by the volume that is missing.
vec3 relativeOf(uint row, uint p, vec4 weights, out vec3 swollen) {
    uvec4 vertices = fetch(rowVertices, row);
    vec2 own = reaches[p].zw;
    vec2 met = weights.x < 0.0 ? own : reaches[uint(weights.x)].zw;
    weights.x = firstWeight(weights);
    vec3 relative = vec3(0.0);
    swollen = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        if (weights[k] == 0.0) continue;
        vec2 reach = weights[k] < 0.0 ? met : own;
        vec3 pressure = fetch(pressures, vertices[k]).xyz;
        relative += weights[k] * (fetch(directions, vertices[k]).xyz + reach.y * pressure);
        swollen += (weights[k] * reach.x) * pressure;
    }
    return relative;
}
#else
vec3 relativeOf(uint row, uint p, vec4 weights, out vec3 swollen) {
    uvec4 vertices = fetch(rowVertices, row);
    weights.x = firstWeight(weights);
    vec3 relative = vec3(0.0);
    swollen = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        if (weights[k] != 0.0) relative += weights[k] * fetch(directions, vertices[k]).xyz;
    }
    return relative;
}
#endif

void moveRow(uint row, vec3 normal, vec3 by) {
    vec4 state = stateAt(2u * row);
    float opening = dot(normal, by);
    states[2u * row] = state + vec4(by - opening * normal, opening);
}

void leaveRelatives(uint root) {
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        uint count = pieceAt(p).row_count;
        for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
            uint row = rowOf(p, k);
            vec3 swollen;
            vec3 relative = relativeOf(row, p, fetch(rows, kRowTexels * row + 2u), swollen);
            relatives[row] = vec4(relative, 0.0);
#ifdef OF_START
            moveRow(row, fetch(rows, kRowTexels * row).xyz, swollen);
#endif
        }
    }
}

// First and second derivative of what a contact adds to the energy along the direction.
vec2 bendOf(uint row, float alpha) {
    vec3 normal = fetch(rows, kRowTexels * row).xyz;
    float stiffness = stiffnessOf(row);
    float lead = fetch(rows, kRowTexels * row + 3u).w;
    vec4 state = stateAt(2u * row);
    vec4 pushes = stateAt(2u * row + 1u);
    float most = pushes.x;
    vec3 relative = relativeAt(row);
    float opening = dot(normal, relative);
    vec3 across = relative - opening * normal;
    Push push = pushOf(stiffness, state.w + alpha * opening, pushes, lead);
    vec2 bend = vec2(-push.force * opening, push.firmness * opening * opening);
    vec3 slip = state.xyz + alpha * across;
    float grip = most > 0.0 ? gripOf(stiffness, slip, most) : 0.0;
    return bend + grip * vec2(dot(slip, across), dot(across, across));
}

const uint kSearchRows = 64u;
shared vec2 searched[kSearchRows];

// Over all contacts of the pieces that touch.
vec2 bendOfAll(uint root, float alpha) {
    for (uint place = gl_LocalInvocationID.x; place < kSearchRows; place += GROUP) {
        vec2 sum = vec2(0.0);
        for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
            uint count = pieceAt(p).row_count;
            for (uint k = place; k < count; k += kSearchRows) sum += bendOf(rowOf(p, k), alpha);
        }
        searched[place] = sum;
    }
    barrier();
    vec2 sum = vec2(0.0);
    for (uint place = 0u; place < kSearchRows; ++place) sum += searched[place];
    barrier();
    return sum;
}

const uint kMostTurns = 6u;
const float kSettled = 1e-4;

// Where the slope would be none if the line bent evenly.
float reachOf(Touching all, vec2 bend, float alpha) {
    float slope = all.slope - alpha * all.curve - bend.x;
    float by = ratio(slope, all.curve + bend.y);
    return alpha == 0.0 && by * slope > all.most ? 0.0 : by;
}

float search(Touching all) {
    if (all.row_count == 0u || !(all.curve > 0.0)) return reachOf(all, vec2(0.0), 0.0);
    float alpha = 0.0;
    for (uint turn = 0u; turn < kMostTurns; ++turn) {
        vec2 bend = bendOfAll(all.root, alpha);
        float by = reachOf(all, bend, alpha);
        alpha += by;
        if (abs(by) <= kSettled * abs(alpha)) break;
    }
    return alpha;
}

// Goes along the direction, and adds up what it pushes there. `p`: whose row it is.
void pushAt(uint row, uint p, float alpha) {
    ContactRow contact = rowAt(row);
    vec3 normal = contact.normal.xyz;
    float stiffness = contact.slip.w;
    vec3 relative = relativeAt(row);
    float opening = dot(normal, relative);
    vec4 state = stateAt(2u * row);
    state += alpha * vec4(relative - opening * normal, opening);
    states[2u * row] = state;
    vec4 pushes = stateAt(2u * row + 1u);
    float push = pushOf(stiffness, state.w, pushes, contact.lead.w).force;
    bool renews = numbers.y != 0u && normal != vec3(0.0) && contact.lead.w >= 0.0;
    float most = renews ? implicit.contact.friction * max(push, 0.0) : pushes.x;
    states[2u * row + 1u] = vec4(most, push, pushes.zw);
    float grip = most > 0.0 ? gripOf(stiffness, state.xyz, most) : 0.0;
    vec3 force = push * normal - grip * state.xyz;
    if (force == vec3(0.0)) return;
    uvec4 vertices = fetch(rowVertices, row);
    float own = forceUnitOf(p);
    float met = contact.weights.x < 0.0 ? own : forceUnitOf(uint(contact.weights.x));
    vec4 weights = vec4(firstWeight(contact.weights), contact.weights.yzw);
    for (int k = 0; k < 4; ++k) {
        float unit = weights[k] < 0.0 ? met : own;
        if (weights[k] != 0.0) addFixed(4u * vertices[k], unit, weights[k] * force);
    }
}

void pushAll(uint root, float alpha) {
    for (uint p = root; p != kNoPiece; p = pieceAt(p).next) {
        uint count = pieceAt(p).row_count;
        for (uint k = gl_LocalInvocationID.x; k < count; k += GROUP) {
            pushAt(rowOf(p, k), p, alpha);
        }
    }
}

#ifdef OF_START
bool goesOn(uint root) { return true; }
#else
bool goesOn(uint root) { return !hasEnded(root); }
#endif

// What contacts push where the iterations have ended.
void stay(uint root) {
    if (gl_LocalInvocationID.x == 0u) {
        for (uint p = root; p != kNoPiece; p = pieceAt(p).next) reaches[p] = vec4(0.0);
    }
    pushAll(root, 0.0);
}

void main() {
    uint root = gl_WorkGroupID.x;
    if (pieceAt(root).root != root) return;
    if (!goesOn(root)) {
        if (numbers.z != 0u) stay(root);
        return;
    }
    Touching all = begin(root);
    memoryBarrier();
    barrier();
    leaveRelatives(root);
    memoryBarrier();
    barrier();
    float alpha = search(all);
    end(root, alpha);
    pushAll(root, alpha);
}
