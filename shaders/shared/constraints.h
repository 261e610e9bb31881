// Constraint records, std430. Compliances are stored times Young's modulus (geometry only), so that
// stiffness sliders change a uniform and not the records: alpha = geometry / modulus.
#ifndef KERF_CONSTRAINTS_H
#define KERF_CONSTRAINTS_H
#include "shared_types.h"
SHARED_BEGIN

// C = |p_a - p_b| - rest_length; alpha = geometry / E_stretch, geometry = L^2 / (t (A1 + A2)).
struct EdgeConstraint {
    uint a;
    uint b;
    float rest_length;  // [m]
    float geometry;     // [1/m]
};

// Signed dihedral angle of the edge v0 v1 with apexes v2 (left) and v3 (right), flat 0, convex > 0.
// alpha = geometry / E_bend, geometry = 1 / (0.3 t^3 / 12).
struct BendConstraint {
    uint v0;
    uint v1;
    uint v2;
    uint v3;
    float rest_angle;  // [rad]
    float geometry;    // [1/m^3]
};

// Internal shape-preserving constraint: from a vertex along its inward normal to the barycentric
// point b0 t0 + b1 t1 + b2 t2 on the opposite side. alpha = geometry / E_ispc,
// geometry = 2 N_rays L0 / A_v.
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
#endif
