// The numbers of one substep that hold for the whole body, as a std140 uniform block or std430
// record. Filled by solverUniforms() (sim/body/solver_uniforms.h).
#pragma once
#include "constraints.h"
#include "shared_types.h"
SHARED_BEGIN

// Bits of SolverUniforms.active_parts, behind those of the constraints: a part that is not set is
// skipped.
SHARED_CONST uint kFloorPart = 1u << kConstraintTypes;
SHARED_CONST uint kVolumePart = 2u << kConstraintTypes;
SHARED_CONST uint kPullAsBeforePart = 4u << kConstraintTypes;   // see pull_direction.glsl
SHARED_CONST uint kUnfoldPart = 8u << kConstraintTypes;         // see unfold/goals.comp
SHARED_CONST uint kUnfoldFirmlyPart = 16u << kConstraintTypes;  // see kFirmUnfoldDamping
SHARED_CONST uint kTrueModulusPart = 32u << kConstraintTypes;   // see sweep_room

// |C| of a bend is clamped here [rad]: the form that comes back after a snap-through.
SHARED_CONST float kMaxBendError = 0.3f;

// A rigid bend is left out where its free vertices change it less than that, as a share of what
// they would do as its apexes (squared gradients): see constraints/bend.glsl.
SHARED_CONST float kLeastBendShare = 1e-4f;

// Rate r of the springs of hands [1/s]: held vertices follow in about 1 / r.
SHARED_CONST float kPullRate = 120.0f;

// Compliance of a constraint over h^2: its geometry * compliance[type].
struct SolverUniforms {
    vec4 gravity;           // xyz [m/s^2]; w: the stretch of shorter edges is measured as if they
                            // were as long [m], set by SolverBody
    float substep;          // h = dt / n [s]
    float drag_factor;      // exp(-c h): v = d / h * drag_factor
    float inverse_density;  // w = inverse_density / unit_mass [m^3/kg]
    float damping_ratio;    // gamma = beta / h
    // By type of constraint: 1 / (E h^2) [1/(Pa s^2)], 0 is rigid; the share of a correction that a
    // sweep applies, 1, or k' of plain PBD; how many there are, as the counts below.
    float compliance[kConstraintTypes];
    float share[kConstraintTypes];
    uint count[kConstraintTypes];
    // By type, with kTrueModulusPart: there an impulse is divided by its compliance alone, so that
    // a sweep adds none of its own. Least compliance, over 3/4 + gamma/2 of what a sweep would add:
    // see sweepRoom() in sim/body/solver_uniforms.h.
    float sweep_room[kConstraintTypes];
    float friction;      // Coulomb coefficient against the floor
    float floor_height;  // [m]
    float lift_speed;    // at which what starts below the floor comes up: not at once, which would
                         // shoot it off [m/s]
    uint active_parts;   // which of the k...Part bits are on
    uint substeps;       // per time step
    uint sweeps;         // over all constraints, per substep
    uint vertex_count;   // the counts of the body model; 0 where only parameters are known
    uint triangle_count;
    uint piece_count;
    uint pull_count;       // vertices that hands hold
    float runaway_speed;   // a vertex that is faster is lost [m/s]; set by SolverBody
    float catch_up_speed;  // catchUpSpeed() in sim/body/solver_uniforms.h [m/s]
};

SHARED_END
