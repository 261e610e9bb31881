// Records and bindings of the kernels for contact with the body of the blade, std430. They go with
// those of boxes.
#pragma once
#include "box_records.h"
SHARED_BEGIN

SHARED_CONST uint kBladeBeforeBinding = 5u;     // vec4: d before the blade changes it
SHARED_CONST uint kBladeLoadsBinding = 6u;      // VertexLoad
SHARED_CONST uint kBladeRangesBinding = 8u;     // IncidenceRange per vertex: of
SHARED_CONST uint kBladeIncidenceBinding = 9u;  // 4 * triangle + corner
SHARED_CONST uint kBladeAroundBinding = 13u;    // vec4: X before the blade moves any vertex

// The body of the blade in a substep. Its box has the axes along AB, to the back and across the
// flat sides, holds what lies between the end of the bevel and the back, and is as it lies at X.
struct BladeRecord {
    BoxRecord box;
    vec4 shift;  // xyz: way of the box's centre in the substep [m]; w: y at which the bevel begins
    vec4 turn;   // xyz: the way that it turns, axis times angle [rad]; w: half thickness, where no
                 // bevel takes it away [m]
    vec4 bevel;  // x: length along y over which the thickness grows [m]; yzw unused
};

// What the blade has done to a vertex in the substeps of a time step so far.
struct VertexLoad {
    vec4 given;   // xyz: sum of mass times change of d [kg m]; w unused
    vec4 moment;  // xyz: of that about the middle of the blade's box [kg m^2]; w unused
};

SHARED_END
