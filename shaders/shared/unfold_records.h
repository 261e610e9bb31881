// What unfolds the surface: see shaders/sim/unfold/goals.comp.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

// A bend is folded from the first angle of its turn from rest on, entirely from the second: 60 and
// 90 degrees. The cosines of both.
SHARED_CONST float kFoldBegins = 0.5f;
SHARED_CONST float kFoldEnds = 0.0f;
// A triangle is squashed from the first share of its area at rest on, entirely from the second.
SHARED_CONST float kSquashBegins = 0.5f;
SHARED_CONST float kSquashEnds = 0.2f;

// Of the spring that unfolds: its rate [1/s], and its damping, which is critical at 2 and more than
// that here, so that what unfolds creeps. While a blade cuts, and otherwise: a damping that is so
// much firmer holds against loads, but beside the blade it left ends of slits inside.
SHARED_CONST float kUnfoldRate = 3000.0f;
SHARED_CONST float kUnfoldDamping = 4.0f;
SHARED_CONST float kFirmUnfoldDamping = 32.0f;

// Where a vertex and its neighbours would lie as they do at rest, and how they would move as one
// rigid body.
struct UnfoldGoal {
    vec4 rotation;  // from the rest shape: a quaternion, its real part last
    vec4 center;    // xyz: of mass [m]; w: 1, or 0 where they have no rigid motion (all on a line)
    vec4 rest_center;  // xyz: of mass at rest [m]; w: share of the way that the spring knows
    vec4 velocity;     // xyz: of the center [m/s]; w unused
    vec4 spin;         // xyz: angular velocity [rad/s]; w unused
};

// Storage and texture units, beside those of the uniforms, X, velocities and the lists of
// neighbours.
SHARED_CONST uint kUnfoldRestBinding = 4u;   // texels of rest positions [m]
SHARED_CONST uint kUnfoldBendsBinding = 5u;  // texels of BendRecord
// Float per vertex: the largest fold of its bends.
SHARED_CONST uint kUnfoldFoldsBinding = 8u;
SHARED_CONST uint kUnfoldGoalsBinding = 10u;  // UnfoldGoal per vertex

SHARED_END
