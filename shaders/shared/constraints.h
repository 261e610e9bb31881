// The constraints that a sweep solves, one row each in the order in which it does:
// ROW(number, Name, list of BodyModel, record of the CPU, how vertices gather what it does).
//
// Lists, buffers, uniforms, kernels, reference and energy follow from the rows, and from functions
// that are found by the record or by the name: docs/developing.md names them. Gathered are
//   Spokes     what each vertex works out anew for itself; there is no record on the GPU,
//   WingPulls  two pulls per constraint, on the triangles beside an edge (BendRange),
//   Shares     one pull per constraint, of which each vertex takes a share (ConstraintShare).
#pragma once
#include "shared_types.h"

// What follows the last in a sweep may share the dispatch in which it is gathered.
#define KERF_PULLING_FIRST(ROW) ROW(1u, Bend, bends, BendConstraint, WingPulls)
#define KERF_PULLING_LAST(ROW) ROW(2u, Ispc, ispcs, IspcConstraint, Shares)

#define KERF_PULLING(ROW) KERF_PULLING_FIRST(ROW) KERF_PULLING_LAST(ROW)
#define KERF_CONSTRAINTS(ROW) ROW(0u, Stretch, edges, EdgeConstraint, Spokes) KERF_PULLING(ROW)

SHARED_BEGIN

// kStretch, ..., and the bit of SolverUniforms.active_parts that turns it on: kStretchPart, ...
#define KERF_NUMBER(number, Name, list, Constraint, Gather) \
    SHARED_CONST uint k##Name = number;                     \
    SHARED_CONST uint k##Name##Part = 1u << number;
KERF_CONSTRAINTS(KERF_NUMBER)
#undef KERF_NUMBER

#define KERF_ONE_MORE(number, Name, list, Constraint, Gather) +1u
SHARED_CONST uint kConstraintTypes = 0u KERF_CONSTRAINTS(KERF_ONE_MORE);
#undef KERF_ONE_MORE

// Internal shape-preserving constraint: from a vertex along its inward normal to the barycentric
// point b0 t0 + b1 t1 + b2 t2 on the opposite side. alpha = geometry / E_ispc,
// geometry = 2 N_rays L0 / A_v. (Compliances are stored times the modulus, so that stiffness
// sliders change a uniform and not the records.)
struct IspcConstraint {
    uint vertex;
    uint t0;
    uint t1;
    uint t2;
    float b1;
    float b2;           // b0 = 1 - b1 - b2
    float rest_length;  // L0 [m]
    float geometry;     // [1/m]
};

SHARED_END
