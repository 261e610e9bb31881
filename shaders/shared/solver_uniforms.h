// The numbers of a step that hold for the whole body, as a std430 record. Filled by
// solverUniforms() (sim/body/solver_uniforms.h).
#pragma once
#include "constraints.h"
#include "shared_types.h"
SHARED_BEGIN

// Bits of SolverUniforms.active_parts, behind those of the constraints: a part that is not set is
// skipped.
SHARED_CONST uint kFloorPart = 1u << kConstraintTypes;
SHARED_CONST uint kVolumePart = 2u << kConstraintTypes;
SHARED_CONST uint kUnfoldPart = 4u << kConstraintTypes;        // see unfold/goals.comp
SHARED_CONST uint kUnfoldFirmlyPart = 8u << kConstraintTypes;  // see kFirmUnfoldDamping

// |C| of a bend is clamped here [rad]: the form that comes back after a snap-through.
SHARED_CONST float kMaxBendError = 0.3f;

// A bend is left out of a sweep where its free vertices change it less than that, as a share of
// what they would do as its apexes (squared gradients): see constraints/bend.glsl.
SHARED_CONST float kLeastBendShare = 1e-4f;

// No constraint resists its vertices more than so many times what their inertia does in a stage of
// an implicit step, which is this share of it: floats, and edges shorter than floats tell apart,
// hold no more.
SHARED_CONST float kMostFirmness = 1e7f;
SHARED_CONST float kStageShare = 0.292893219f;  // 1 - sqrt(1/2)

// Rate r of the springs of hands [1/s]: held vertices follow in about 1 / r.
SHARED_CONST float kPullRate = 120.0f;

struct SolverUniforms {
    vec4 gravity;           // xyz [m/s^2]; w: the stretch of shorter edges is measured as if they
                            // were as long [m], set by SolverBody
    float substep;          // h: of a step of plain PBD, or an implicit one [s]
    float drag_factor;      // exp(-c h): v = d / h * drag_factor
    float inverse_density;  // w = inverse_density / unit_mass [m^3/kg]
    uint substeps;          // implicit steps per time step; 1 of plain PBD
    // By type of constraint: E [Pa], with which its energy is E C^2 / (2 geometry); 0: it has none,
    // as all in plain PBD. The share k' of a correction that a sweep applies. How
    // many there are, as the counts below.
    float modulus[kConstraintTypes];
    float share[kConstraintTypes];
    uint count[kConstraintTypes];
    float friction;      // Coulomb coefficient against the floor
    float floor_height;  // [m]
    float lift_speed;    // at which what starts below the floor comes up: not at once, which would
                         // shoot it off [m/s]
    uint active_parts;   // which of the k...Part bits are on
    uint sweeps;         // of plain PBD; 0 in implicit steps
    uint vertex_count;   // the counts of the body model; 0 where only parameters are known
    uint triangle_count;
    uint piece_count;
    uint pull_count;       // vertices that hands hold
    float runaway_speed;   // a vertex that is faster is lost [m/s]; set by SolverBody
    float catch_up_speed;  // catchUpSpeed() in sim/body/solver_uniforms.h [m/s]
};

SHARED_END
