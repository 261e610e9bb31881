// Records of the implicit solver, std430: see docs/notes/implicit-steps.md.
#pragma once
#include "body_records.h"
#include "constraints.h"
#include "shared_types.h"
SHARED_BEGIN

// Storage bindings of its kernels, besides those of positions, velocities and gradients
// (bindings.h); the same numbers are texture and image units.
SHARED_CONST uint kImplicitBinding = 0u;       // one: ImplicitUniforms
SHARED_CONST uint kResidualBinding = 3u;       // per vertex: what is left of the forces [N]
SHARED_CONST uint kAnswerBinding = 4u;         // per vertex: of the preconditioner to it [m]
SHARED_CONST uint kDirectionBinding = 5u;      // per vertex: along which it moves [m]
SHARED_CONST uint kImageBinding = 6u;          // per vertex: the matrix times that [N]
SHARED_CONST uint kWayBinding = 7u;            // per vertex: how far the stage has moved it [m]
SHARED_CONST uint kPressureBinding = 8u;       // per vertex: the answer to dV/dp [m^3/N]
SHARED_CONST uint kPressureImageBinding = 9u;  // per vertex: the matrix times that [m^2]
SHARED_CONST uint kForceBinding = 11u;         // per vertex: elastic force [N]
SHARED_CONST uint kMadeCoursesBinding = 11u;   // per piece: Course
SHARED_CONST uint kProductSumsBinding = 12u;   // per slot and page: ProductSums
SHARED_CONST uint kAnswerSumsBinding = 13u;    // per slot and aggregate: AnswerSums
SHARED_CONST uint kCoursesUnit = 13u;          // per piece: Course
// Three texels each: per aggregate, then per region the residual by modes, per region its motion.
SHARED_CONST uint kModesBinding = 14u;
SHARED_CONST uint kFirstWayBinding = 15u;  // per vertex: way of the first stage [m]
// Of kernels that write what the others fetch.
SHARED_CONST uint kMadeFactorsBinding = 3u;
SHARED_CONST uint kMadePullsBinding = 4u;
SHARED_CONST uint kMadeBlocksBinding = 3u;
SHARED_CONST uint kMadeTurnsBinding = 3u;
SHARED_CONST uint kTurnedBinding = 10u;  // per member: its residual, as its patch has turned
SHARED_CONST uint kTurnedUnit = 30u;     // the same
// Of contact: written, then fetched by the units below.
SHARED_CONST uint kTotalBinding = 15u;  // per vertex two: what is left of all forces, by turns [N]
SHARED_CONST uint kContactForcesBinding = 1u;    // per vertex: ivec4, in force_unit
SHARED_CONST uint kRelativeBinding = 2u;         // per row: along the direction, see reach.comp
SHARED_CONST uint kReachesBinding = 8u;          // per piece: Reach
SHARED_CONST uint kRowStatesBinding = 9u;        // per row: RowState
SHARED_CONST uint kMadeRowsBinding = 3u;         // per row: ContactRow
SHARED_CONST uint kMadeRowVerticesBinding = 5u;  // per row: its vertices, uvec4
SHARED_CONST uint kParentsBinding = 6u;          // per piece: one that it touches, or itself
SHARED_CONST uint kMadePiecesBinding = 7u;       // per piece: ImplicitPiece
SHARED_CONST uint kMadeListBinding = 8u;         // per piece: its rows
SHARED_CONST uint kMeetContactBinding = 9u;      // one: ContactUniforms
SHARED_CONST uint kKeptSlipsBinding = 3u;        // per row of a vertex: see end.comp
SHARED_CONST uint kMeetObstacleBinding = 7u;     // one: BoxUniforms
SHARED_CONST uint kMeetBoxesUnit = 18u;          // BoxRecord
SHARED_CONST uint kMeetPieceBoundsUnit = 19u;    // PieceBounds, by words
SHARED_CONST uint kMeetTrianglesUnit = 20u;      // as BodyView has them
SHARED_CONST uint kMeetRangesUnit = 21u;         // per vertex: of
SHARED_CONST uint kMeetIncidenceUnit = 22u;      // 4 * triangle + corner
SHARED_CONST uint kPressEdgeBinding = 7u;        // one: EdgeUniforms
SHARED_CONST uint kPressWeightsBinding = 8u;     // see kEdgeWeightsBinding
SHARED_CONST uint kPressStateBinding = 9u;       // one: EdgeState
SHARED_CONST uint kMadeLoadsBinding = 7u;        // per vertex: VertexLoad
SHARED_CONST uint kLoadBladesBinding = 8u;       // per substep: BladeRecord
SHARED_CONST uint kMeetStateBinding = 8u;        // one: ContactState
SHARED_CONST uint kPullRowsBinding = 3u;         // as kMadeRowsBinding
SHARED_CONST uint kPullVerticesBinding = 7u;     // as kMadeRowVerticesBinding
SHARED_CONST uint kDriftUnit = 0u;  // per vertex: the matrix times the way of what is held [N]
SHARED_CONST uint kContactForcesUnit = 0u;
SHARED_CONST uint kRelativeUnit = 2u;
SHARED_CONST uint kReachesUnit = 11u;
SHARED_CONST uint kTotalUnit = 15u;
SHARED_CONST uint kContactRowsUnit = 27u;
SHARED_CONST uint kRowVerticesUnit = 28u;
SHARED_CONST uint kRowListUnit = 29u;
SHARED_CONST uint kRowStatesUnit = 31u;
SHARED_CONST uint kFirmnessUnit = 16u;   // per vertex, see contactFirmness() [N/m]
SHARED_CONST uint kKeptSlipsUnit = 17u;  // per row of a vertex: see end.comp
// Of the end of a step.
SHARED_CONST uint kMotionsBinding = 13u;      // per aggregate: AggregateMotion
SHARED_CONST uint kMadeSpinsBinding = 14u;    // per piece: spin [1/s], middle [m]
SHARED_CONST uint kEndContactsBinding = 15u;  // one: ContactState
SHARED_CONST uint kMotionsUnit = 16u;
SHARED_CONST uint kSpinsUnit = 17u;
// Texture and image units of what only a cut changes.
SHARED_CONST uint kRowsUnit = 16u;          // per vertex: first and end of its blocks
SHARED_CONST uint kBlocksUnit = 17u;        // per block: three rows; column in the first w
SHARED_CONST uint kRowOrderUnit = 18u;      // per place on a page: its vertex, long rows first
SHARED_CONST uint kPageTableUnit = 19u;     // the pages of each piece
SHARED_CONST uint kAggregatesUnit = 20u;    // per aggregate: ImplicitAggregate
SHARED_CONST uint kMembersUnit = 21u;       // per member of an aggregate: ImplicitMember
SHARED_CONST uint kMemberSharesUnit = 22u;  // per member: its share of the modes 3 to 11
SHARED_CONST uint kPatchInverseUnit = 23u;  // per block of a patch's inverse: three rows
SHARED_CONST uint kCoarseUnit = 24u;        // rows of the inverse: see ImplicitAggregate::coarse
SHARED_CONST uint kPatchesUnit = 23u;       // per patch: first and end of its members
SHARED_CONST uint kRestUnit = 24u;          // per vertex: place at rest [m]
SHARED_CONST uint kTurnsUnit = 25u;         // per patch, aggregate, region: a quaternion
SHARED_CONST uint kRegionsUnit = 18u;       // per region: ImplicitRegion
// Per aggregate two: what its shares of modes are in those of its region, off + by * share. The w
// of the first is the region.
SHARED_CONST uint kLevelsUnit = 19u;
SHARED_CONST uint kPiecesUnit = 26u;       // per piece: ImplicitPiece
SHARED_CONST uint kBlockListUnit = 27u;    // per block: ImplicitBlock
SHARED_CONST uint kBlockSharesUnit = 28u;  // what adds up to the blocks: see kSlotBits
SHARED_CONST uint kOwnSharesUnit = 27u;    // per vertex: first and end of its own shares
SHARED_CONST uint kFactorsUnit = 29u;      // per slot of a constraint: see factors.comp
SHARED_CONST uint kPullsUnit = 30u;        // per two texels of those: force over root of stiffness
SHARED_CONST uint kSpokeOwnersUnit = 31u;  // per spoke: its vertex

// Of the contact of a step.
struct ImplicitContact {
    float friction;      // Coulomb coefficient
    float floor_height;  // far below all where there is none [m]
    float reach;         // of the floor: nearer than that is met at any speed [m]
    float stiffness;     // of a mass: the square of contactRate() [1/s^2]
    float let_out;       // of a depth that no push has made, at most [m]
};

// What is neglected.
struct ImplicitBounds {
    float firmest;  // of a constraint, over the sum of w |grad C|^2: see kMostFirmness [1/s^2]
    // Iterations end where less of the energy of the motion is left, but for half of them.
    float close;
    float unused_a;
    float unused_b;
};

// The numbers of a step that hold for the whole body.
struct ImplicitUniforms {
    vec4 gravity;                     // xyz [m/s^2]
    float stage;                      // s = (1 - sqrt(1/2)) h [s]
    float inertia;                    // 1 / s^2 [1/s^2]
    float rest;                       // h - s [s]
    float damping;                    // 2 beta / h: of the stiffness
    float kept;                       // of a velocity: exp(-c h)
    float inverse_density;            // w = inverse_density / unit_mass [m^3/kg]
    float modulus[kConstraintTypes];  // by type [Pa]
    float step;                       // h [s]
    ImplicitContact contact;
    uint vertex_count;
    uint block_count;
    uint patch_count;
    uint aggregate_count;
    uint page_count;  // of the table of pages
    uint piece_count;
    uint holds_volume;  // 0: no piece is held
    uint region_count;  // 0: each aggregate is one
    ImplicitBounds bounds;
};

// A block of the matrix, and what adds up to it.
struct ImplicitBlock {
    uint place;  // among the blocks
    uint column;
    uint first;  // of its shares
    uint end;
};

// A share of a block names the factors of a constraint by half of the number of the first, and two
// slots of the constraint, that of the row above that of the column.
SHARED_CONST uint kSlotBits = 4u;

// A crushed triangle turns with the least motion: beyond this multiple of its steepness at rest a
// bend is softer, so that it is no stiffer against motion.
SHARED_CONST float kMostSteepness = 1.0f;

// A spring pressed together by more than this share of its length resists what turns it: free of
// all but mass, a crushed sliver would buckle by metres in a linear step.
SHARED_CONST float kMostBuckling = 0.2f;
SHARED_CONST float kMostAcross = 0.75f;  // of the stiffness along, however crushed or drawn

// Vertices that move together in the coarse part of the preconditioner. Modes 0 to 2 are
// translations; 3 m + axis is one along an axis, times the share m of a vertex.
SHARED_CONST uint kAggregateModes = 12u;
SHARED_CONST uint kMostMembers = 256u;  // of an aggregate
struct ImplicitAggregate {
    uint first;  // of its members; those of a patch lie together
    uint end;
    uint piece;
    uint coarse;  // first texel of its rows of the inverse, or with regions of its own
};

// Aggregates of a piece whose modes are summed up to those of the whole region. Two texels.
struct ImplicitRegion {
    uint first;  // of its aggregates
    uint end;
    uint members_first;
    uint members_end;
    uint of_piece;  // the first region of the piece
    uint piece_count;
    uint coarse;  // first texel of its rows of the inverse
    uint unused;
};

// A vertex, and its rows of the inverse of its patch: as many blocks as that has members.
struct ImplicitMember {
    uint vertex;
    uint patch_number;
    uint neighbours;  // first member of its patch + 2^24 * their number
    uint inverse;     // first block
};

struct ImplicitPiece {
    uint first_page;  // in the table of pages
    uint page_count;
    uint first_aggregate;
    uint aggregate_count;
    // Of the step. Pieces that touch each other go equally far along their direction.
    uint root;       // the first of those
    uint next;       // of them; kNoPiece behind the last
    uint row_count;  // of contact
    // In which forces of contact on its vertices are added up: what is light takes few. Below 0: an
    // obstacle holds the piece. [N]
    float force_unit;
};

// What a vertex meets in a step, a row each, kRowsOfVertex * v + what it is. Behind those of all
// vertices are pulls, then with an edge that presses one more of each vertex. A row pushes by
// stiffness * depth, and holds with the same stiffness across, by friction * push at most. Pulls
// have no normal and hold in all directions.
SHARED_CONST uint kRowsOfVertex = 4u;
SHARED_CONST uint kMeetsObstacle = 0u;  // it meets the floor, or a face of a box or of the blade
SHARED_CONST uint kMeetsTriangle = 1u;  // it meets a triangle
SHARED_CONST uint kMeetsEdge = 2u;      // an edge at it meets an edge
SHARED_CONST uint kMeetsCorner = 3u;    // a triangle at it meets a corner or an edge of an obstacle
struct ContactRow {
    vec4 normal;   // towards the vertex; w: gap where the step begins [m], of a pull its piece
    vec4 slip;     // across, what the step before has left held back [m]; w: stiffness [N/m], 0:
                   // nothing is met
    vec4 weights;  // yzw: of the second to fourth vertex in the gap, below 0 where they are met; x:
                   // their piece, below 0: none of the body. That of the first follows
    vec4 lead;     // how far what is met is led in the step [m]; w: push of the step before [N];
                   // below 0: there is no friction, and -w is the most that pushes [N]
};
SHARED_CONST uint kRowTexels = 4u;
// In the place of the piece that is met.
SHARED_CONST float kOfObstacle = -1.0f;
SHARED_CONST float kOfBlade = -2.0f;
SHARED_CONST float kAnyPush = -1e30f;
// What a row is like where the iterations are. Two texels.
struct RowState {
    vec4 slip;  // w: gap [m]
    vec4 push;  // x: the most that friction holds, below 0: none; y: push, z: of the stage before
                // [N]; w: the gap from where it is damped, or kUndamped [m]
};
// How far a piece goes.
struct Reach {
    float alpha;     // along its direction
    float pressure;  // of dV/dp, that is left in the residual
    // Where a stage begins, of the answer to dV/dp:
    float missing;   // brings the volume back
    float swelling;  // keeps it along the direction
};
SHARED_CONST uint kRowsOfPage = (kRowsOfVertex + 2u) * kPageSize;  // at most
// What leads is as stiff as this multiple of mass / s^2.
SHARED_CONST float kLeadStrength = 4.0f;
// Contacts are as stiff as this share of their vertices, and the square of a rate times mass. That
// is so fast that what is met at any speed goes in by little of its way in a step.
SHARED_CONST float kContactShare = 0.05f;
SHARED_CONST float kContactRate = 600.0f;  // at least [1/s]
SHARED_CONST float kContactTurn = 8.0f;    // in a step
// In the second stage: see contact_rows.glsl.
SHARED_CONST float kDampedContact = 0.2f;  // of its stiffness
SHARED_CONST float kMostPull = 2.4f;       // of the push of the first stage
SHARED_CONST float kUndamped = 1e30f;
SHARED_CONST float kSameNormal = 0.9f;  // cosine
// In a step, of a depth that no push has made; see let_out.
SHARED_CONST float kLetOut = 0.1f;

// Sums that kernels leave in slots: one of the pressure, one of where a stage begins, and one of
// each iteration.
SHARED_CONST uint kPressureSlot = 0u;
SHARED_CONST uint kStartSlot = 1u;
SHARED_CONST uint kFirstSlot = 2u;
// Over the vertices of a page. With p the direction and z its image:
struct ProductSums {
    float direction_image;     // p . z
    float pressure_image;      // pressure . z
    float gradient_direction;  // dV/dp . p
    float direction_residual;  // p . r
    float pressure_residual;   // pressure . r
    // Of the whole piece, the same on each of its pages; not where a stage begins.
    float residual_answer;    // r . z
    float gradient_pressure;  // dV/dp . pressure
    float scale;              // of residual_answer: see scalars.glsl
};
// Over the vertices of an aggregate.
struct AnswerSums {
    float left_answer;      // what is left . z
    float gradient_answer;  // dV/dp . z
    float before_answer;    // what was left an iteration before . z
    float left_pressure;    // what is left . pressure
    // x: what was left before . pressure. At the end of a stage xyz: what is left [N]; w: mass,
    // kHeldMass more where a vertex is held [kg].
    vec4 rest;
};
SHARED_CONST float kHeldMass = 1e30f;

// How the iterations of a piece go on, then how it is moved as a whole when they have ended. The
// group that is done last of all that work for pieces that touch finds it. Three texels.
struct Course {
    float beta;      // of the last direction, how much stays
    float pressure;  // how much goes
    float size;      // left . z without a change of volume, of all that touch
    float gamma;     // dV/dp . pressure
    float scale;     // of left . z: what it was at first, or the energy of the motion
    float done;      // 1: what is left is rounding, along which directions would grow
    float ended;     // 1: the stage needs no more iterations
    uint groups;     // that are done
    vec4 shift;      // [m]
};
SHARED_CONST uint kCourseTexels = 3u;

// Sums over the vertices of an aggregate where a step begins and ends; places are from the first
// vertex of the pieces that touch.
struct AggregateMotion {
    vec4 middle;  // mass times place [kg m]; w: mass, kHeldMass more where held [kg]
    vec4 ended_middle;
    vec4 momentum;  // [kg m/s]
    vec4 ended_momentum;
    vec4 turn;  // angular momentum, with what forces add to it [kg m^2/s]
    vec4 ended_turn;
    vec4 squares;  // of mass, where the step ends [kg m^2]
    vec4 mixed;    // yz, zx, xy
};
SHARED_CONST uint kMotionTexels = 8u;

SHARED_END
