// Records and bindings of the kernels for contact with static boxes, std430.
#pragma once
#include "contact_records.h"
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST uint kBoxUniformsBinding = 0u;      // BoxUniforms
SHARED_CONST uint kBoxPositionsBinding = 1u;     // vec4: X [m], w inverse unit mass
SHARED_CONST uint kBoxDisplacementBinding = 2u;  // vec4: d [m]
SHARED_CONST uint kBoxTrianglesBinding = 3u;     // uvec4, see BodyView
SHARED_CONST uint kBoxBoxesBinding = 4u;         // BoxRecord: those near the body
SHARED_CONST uint kBoxRecordsBinding = 5u;       // BoxTouch per triangle
SHARED_CONST uint kBoxSharesBinding = 6u;        // uint per vertex: touches that it is part of
SHARED_CONST uint kBoxSumsBinding = 7u;          // 6 int per vertex: fixed-point d, then X
SHARED_CONST uint kBoxLinksBinding = 10u;        // VertexLinks
SHARED_CONST uint kBoxPiecesBinding = 11u;       // PieceBounds
SHARED_CONST uint kBoxStartBinding = 12u;  // vec4: X at the beginning of the substep, way since [m]

// Room before what is no plane [m].
SHARED_CONST float kNoPlane = 1e30f;

struct BoxUniforms {
    float thickness;        // distance kept from a box [m]
    float depth;            // farther behind a triangle, nothing of a box touches it [m]
    float lift;             // by how much d may lead out of a box in a substep [m]
    float push;             // by how much a sweep may move X out of one [m]
    float friction;         // Coulomb coefficient
    float inverse_density;  // w = inverse_density / unit_mass [m^3/kg]
    float unit;             // of fixed-point displacements [m]
    float floor_height;     // [m]; far below everything where there is no floor
    uint vertex_count;
    uint triangle_count;
    uint box_count;
};

// A box: its own axes in the world, its half lengths along them.
struct BoxRecord {
    vec4 center;  // xyz [m]; w unused
    vec4 x;       // axis; w: half length [m]
    vec4 y;
    vec4 z;
};

// Where a corner or an edge of a box meets a triangle in a substep.
struct BoxTouch {
    vec4 normal;   // away from the box; w: how far X is to be pushed along it [m]
    vec4 impulse;  // xyz: how d is to change [m]; w: 0 where nothing is touched
    vec4 weights;  // xyz: of the point of the triangle that answers; w unused
};

// Between a triangle and boxes, in the place of its touch.
struct BoxPlanes {
    vec4 first;   // xyz: away from the box; w: how far the corners may go against it in a substep
                  // [m], kNoPlane: there are none, whatever stands behind it
    vec4 second;  // the same, of one with no less room
    vec4 third;
};

SHARED_END
