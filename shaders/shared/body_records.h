// Records of the running body, std430.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST uint kGroupSize = 256u;       // threads of a work group, in every kernel
SHARED_CONST uint kPageSize = kGroupSize;  // places on a page of the vertices of a piece
// The volume constraint adds the sums of the places of a page up in so many rows first.
SHARED_CONST uint kSumRows = 16u;
SHARED_CONST uint kNoPiece = 0xffffffffu;
SHARED_CONST uint kNoVertex = 0xffffffffu;  // a place without a vertex
SHARED_CONST uint kAfterGap =
    0x80000000u;  // of a neighbour: no triangle between it and the last one

// How many constraints of each type that pulls touch a vertex: mass-splitting Jacobi gives each of
// them the share mass / count, hence the inverse mass count * w. One texel.
SHARED_CONST uint kMostPullingTypes = 3u;
struct VertexLinks {
    uint counts[kMostPullingTypes];  // of type 1, 2, ...
    uint piece;                      // kNoPiece for unused and hidden vertices
};

// A piece: its blocks lie together.
struct PieceRecord {
    uint origin;  // a vertex of it, about which its volume is measured
    uint first_block;
    uint block_count;
    uint constrained;     // 0: chips and open pieces, which get no volume constraint
    float target_volume;  // [m^3]
    // Unit mass of a vertex: mass_per_area * max(its rest area, least_area) [m^3].
    float mass_per_area;  // [m]
    float least_area;     // [m^2]
};

// The vertices that one work group sums up: entries of the table of pages, which lie together.
struct BlockRecord {
    uint piece;
    uint first_page;
    uint page_count;
};

// A list of what touches a vertex: entries[first] up to, not including, entries[end].
struct IncidenceRange {
    uint first;
    uint end;
};

// An edge constraint as seen from one of its vertices, in the order of the incidence.
struct Spoke {
    uint other;         // the vertex at its other end
    float rest_length;  // [m]
    float geometry;     // L^2 / (t (A1 + A2)) [1/m]: alpha = geometry / E_stretch
    uint other_count;   // of spokes there
};

// A bend: the edge v0 v1 with apexes v2 (left) and v3 (right); its angle is 0 where it is flat.
// alpha = geometry / E_bend, geometry = 1 / (0.3 t^3 / 12).
struct BendRecord {
    uint v0;
    uint v1;
    uint v2;
    uint v3;
    float rest_cosine;  // of the rest angle
    float rest_sine;
    float geometry;   // [1/m^3]
    float steepness;  // square of the largest gradient of its angle at rest [1/m^2]
};

// The list of the bends at a vertex: first those of which it is an end of the edge, then those of
// which it is an apex.
struct BendRange {
    uint first;   // 2 * bend + (0: v0, 1: v1)
    uint apexes;  // 2 * bend + (0: v2, 1: v3)
    uint end;
    uint unused;
};

// A constraint with one pull as seen from one of its vertices.
struct ConstraintShare {
    uint constraint;
    float weight;  // of its pull
};

// A word that is to be written into a buffer.
struct WordWrite {
    uint word;
    uint value;
};

// A vertex that a hand holds, that is led back to its place at rest, on which a force acts, or
// which is bonded to the facing wall of a tear, for a step.
SHARED_CONST uint kForcePull = 2u;
SHARED_CONST uint kFirstBond = 3u;  // bonded to vertex 0
struct PullRecord {
    uint vertex;
    float target_x;  // where it should be at the end of the step; how a force is drawn [m]
    float target_y;
    float target_z;
    // Of the hand [m/s]; acceleration by a force [m/s^2]; of a bond the largest force [N], the
    // opening at which it breaks and the widest so far [m].
    float motion_x;
    float motion_y;
    float motion_z;
    // 1: it moves as the hand does, whatever pulls at it; 0: by a spring; kForcePull; from
    // kFirstBond on: by a bond to the vertex of that number
    uint leads;
};

SHARED_CONST float kMostStretch = 1e20f;
SHARED_CONST float kLostStretch = 1e30f;
// Of one block, after a step.
struct BlockMeasure {
    // xyz: smallest coordinates [m]; w: share of the volume [m^3]: a third of the sum of
    // (p - origin) . dV/dp
    vec4 low_volume;
    // xyz: largest coordinates [m]; w: how far an edge is stretched most, as a share of its length;
    // kLostStretch where a vertex is lost
    vec4 high_stretch;
    // xyz: smallest components [m/s]; w: kinetic energy [J], as the other of free vertices alone
    vec4 low_velocity_kinetic;
    // xyz: largest components [m/s]; w: energy in the field of gravity [J]
    vec4 high_velocity_potential;
    // xyz: smallest ways since the last search for contacts [m]; w: energy of the strained material
    // of some constraints, not those of the block [J]
    vec4 low_drift_strain;
    vec4 high_drift;  // xyz: largest [m]; w: largest fold of some bends (unfold/folded.glsl)
};

// What a step of the blade wants to know of the vertices once the body has moved. Records follow
// it: first those of vertices asked for by number, then those near the box, in any order.
struct NearbyQuery {
    vec4 center;          // of the box [m]; w unused
    vec4 first_axis;      // xyz: unit vector; w: half the size along it [m]
    vec4 second_axis;     // the same
    vec4 third_axis;      // the same
    uint asks_for_box;    // 0: nothing but the vertices asked for by number
    uint asked_vertices;  // how many those are
    uint capacity;        // of records
    uint count;           // of records; may come out larger than the capacity
    uint unused_a, unused_b, unused_c, unused_d;
};

// The state of a vertex.
struct NearbyVertex {
    uint vertex;
    float x, y, z;     // [m]
    float vx, vy, vz;  // [m/s]
    uint unused;
};

SHARED_END
