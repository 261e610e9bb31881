// The record of an internal constraint, std430. Its compliance is stored times Young's modulus
// (geometry only), so that stiffness sliders change a uniform and not the records:
// alpha = geometry / modulus.
#ifndef KERF_CONSTRAINTS_H
#define KERF_CONSTRAINTS_H
#include "shared_types.h"
SHARED_BEGIN

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
