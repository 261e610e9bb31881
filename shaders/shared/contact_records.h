// Records and numbers of the contact kernels, std430.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

// Triangles that a point is compared with in every substep: the nearest ones.
SHARED_CONST uint kCandidatesPerPoint = 8u;
// Children of a node of the tree of boxes; triangles of a lowest one.
SHARED_CONST uint kTreeFan = 8u;
// Vertices that search the tree together.
SHARED_CONST uint kSearchGroup = 32u;
// Leaves that they look through at once.
SHARED_CONST uint kMostGroupLeaves = 4u * kSearchGroup;

// Candidates are kept up to this motion of what is near against each other, times h.
SHARED_CONST float kKept = 0.25f;

// A vertex and a triangle touch only where their normals oppose each other by more than this.
SHARED_CONST float kOpposed = -0.1f;
// A point beside a triangle touches it up to this distance, times h.
SHARED_CONST float kLateralSlack = 0.02f;
// Pairs nearer than this in the rest shape, times h or the triangle's size, are one material: they
// touch across a slit alone.
SHARED_CONST float kNearInRest = 2.0f;
// A pair of which the vertex lies this deep behind the triangle in the rest shape, times h, is the
// two sides of a slab and not of a slit.
SHARED_CONST float kSlabDepth = 0.05f;
// Up to this distance in the rest shape, times h, opposed pairs with the vertex behind the triangle
// are taken for the two sides of an arm.
SHARED_CONST float kArmWidth = 8.0f;
// A vertex that lies deeper in a triangle than this share of the wall behind it comes from behind.
SHARED_CONST float kDeepInWall = 0.4f;
// A wall where no column begins or ends [m].
SHARED_CONST float kNoWall = 1e30f;
// A later candidate takes the place of an earlier one where its squared distance is below this
// share: neighbours that meet in the nearest point do not change places by rounding.
SHARED_CONST float kNearerBy = 0.9999f;
// Share of a missing thickness that a substep makes up for.
SHARED_CONST float kThicknessRate = 0.1f;
// Widest gap that a load holds open where no thickness is kept, times h.
SHARED_CONST float kHair = 1e-3f;
// Pairs of edges at each point, the nearest ones.
SHARED_CONST uint kEdgePairsPerPoint = 4u;
// Edges meet where the line across both leans no farther from the normals of their surfaces:
// cosine.
SHARED_CONST float kAcross = 0.3f;
// Share of the thickness that edges keep: where surfaces lie flat on each other, vertices carry,
// which have friction.
SHARED_CONST float kEdgeThickness = 0.8f;
// Thickness of edges that were beside each other, times h: none but that they count.
SHARED_CONST float kBareEdge = 1e-6f;
// From the ends of such edges on they are left to the vertices: share of the length.
SHARED_CONST float kBareEnd = 0.02f;
// Edges that lie this deep in each other, times h, are left to the vertices.
SHARED_CONST float kEdgeDepth = 0.25f;

// Bits of the w of a vertex normal: what its triangles are.
SHARED_CONST uint kTouchesSkin = 1u;
SHARED_CONST uint kTouchesWall = 2u;

struct ContactUniforms {
    float h;                // edge length of walls [m], unit of the lengths above
    float reach;            // pairs this near are candidates whatever their speed [m]
    float interval;         // time until candidates are looked for anew [s]
    float margin;           // no pair is a candidate beyond this [m]
    float thickness;        // distance kept from what was never one material [m]
    float substep;          // [s]
    float lift_speed;       // at which penetrations are taken back [m/s]
    float friction;         // Coulomb coefficient
    float inverse_density;  // w = inverse_density / unit_mass [m^3/kg]
    float unit;             // of fixed-point displacements [m]
    uint vertex_count;
    uint triangle_count;
};

SHARED_CONST uint kNoBin = 24u;  // of a triangle without an area, or of a chip

// The box around the vertices of a piece, as words in the order of the floats, see
// ordered_floats.glsl.
struct PieceBounds {
    uint low_x, low_y, low_z;
    uint high_x, high_y, high_z;
};

// A triangle that a point may touch.
struct ContactCandidate {
    uint triangle;    // kNoVertex: none, and none after it
    float thickness;  // [m]
};

// An edge at a point that may touch an edge of a triangle.
struct EdgePair {
    uint other;       // end of the edge from the point; kNoVertex: none, and none after it
    uint edge;        // 4 * triangle + the corner at which its edge begins
    float thickness;  // [m]
};

// What a point or an edge at it touches in a substep.
struct ContactRecord {
    vec4 normal;   // towards the point; w: how far X is to be pushed apart along it [m]
    vec4 impulse;  // xyz: how the difference of the d is to change [m]; w: ContactAnswer.least
    vec4 gains;    // of the vertices in that difference
    uint v0;       // the point
    uint v1;       // kNoVertex: nothing is touched
    uint v2;
    uint v3;
};

// Counts, and the work groups of the kernels that run over what was counted.
struct ContactState {
    uint point_groups;  // over the points with candidates
    uint point_groups_y;
    uint point_groups_z;
    uint vertex_groups;  // over all vertices: none where there are no candidates
    uint vertex_groups_y;
    uint vertex_groups_z;
    uint points;         // with candidates
    uint contacts;       // so far in this substep
    uint last_contacts;  // in the last substep
    uint fitted_groups;  // of the tree of boxes, while it is fitted
};

// In the paper's contact: normals face the same way where their difference, squared, is below this.
SHARED_CONST float kFacesAlike = 0.25f;
// Triangles approach each other where they do so by more than this, times a push, in a time step.
SHARED_CONST float kStandsStill = 1e-3f;

// What the triangles of other pieces that a triangle meets ask of it in the paper's contact: fixed
// point, in units of the uniforms, and sums over all of them.
struct PaperRequest {
    int loss_x, loss_y, loss_z;  // of velocity, as the way of a time step
    int push_x, push_y, push_z;  // of positions alone
    uint count;                  // of triangles that it meets
};

SHARED_END
