// All types of constraints with pulls: solveNAME(records, index) sets the pulls of one, and
// energyOfNAME(records, index) is its energy at X [J]. The includer declares `uniforms`,
// positionOf(v), displacementOf(v) and setCorrection(index, pull).

// C^2 E / (2 geometry) [J]; what is rigid holds none. `square`: C^2, or what stands for it;
// `moved`: the sum of |grad C|^2 over unit mass, by which kMostFirmness bounds it.
float energyOf(float square, float geometry, uint type, float moved) {
    float stiffness = geometry > 0.0 ? uniforms.modulus[type] / geometry : 0.0;
    float stage = kStageShare * uniforms.substep * float(uniforms.substeps);
    float firmest = kMostFirmness / (stage * stage);
    return 0.5 * square *
        min(stiffness, firmest / max(uniforms.inverse_density * moved, 1e-30));
}

#include "sim/constraints/*.glsl"
