// All types of constraints with pulls: solveNAME(records, index) sets the pulls of one, and
// energyOfNAME(records, index) is its energy at X [J]. The includer declares `uniforms`,
// positionOf(v), displacementOf(v) and setCorrection(index, pull).
#include "sim/folds.glsl"
#include "sim/pull_direction.glsl"

// C^2 / (2 alpha) [J]; what is rigid holds none. `square`: C^2, or what stands for it.
float energyOf(float square, float geometry, uint type) {
    float alpha = geometry * uniforms.compliance[type] * uniforms.substep * uniforms.substep;
    return alpha > 0.0 ? 0.5 * square / alpha : 0.0;
}

#include "sim/constraints/*.glsl"
