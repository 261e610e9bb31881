// Records and bindings of the kernels for the edge of a blade that presses on a body, std430.
#pragma once
#include "shared_types.h"
SHARED_BEGIN

SHARED_CONST uint kEdgeUniformsBinding = 0u;   // EdgeUniforms
SHARED_CONST uint kEdgePositionsBinding = 1u;  // vec4: X [m], w inverse unit mass
SHARED_CONST uint kEdgeWeightsBinding = 2u;    // float per vertex: how much it answers, 0 to 1
SHARED_CONST uint kEdgeStateBinding = 3u;      // EdgeState

struct EdgeUniforms {
    vec4 from;              // xyz: end of the part that touches [m]; w: reach [m]
    vec4 to;                // xyz: the other end [m]; w: compliance of the spring over h^2 [1/kg]
    vec4 ahead;             // xyz: direction, unit; w: largest impulse of a substep [kg m]
    float lag;              // how far the material holds the edge back as the step begins [m]
    float way;              // that the edge is led ahead in a substep [m]
    float inverse_density;  // w = inverse_density / unit_mass [m^3/kg]
    uint vertex_count;
};

struct EdgeState {
    vec4 middle;    // xyz: of where the edge acts, from EdgeUniforms::from [m]; w: mass that
                    // answers, each vertex by its weight [kg]
    float inverse;  // inverse mass of the material to the edge [1/kg]
    float gone;     // how far the material has gone ahead in the substeps so far [m]
    float impulse;  // the sum over the substeps so far [kg m]
    float work;     // of what leads the edge so far, times h^2 [kg m^2]
};

SHARED_END
