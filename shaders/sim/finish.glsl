// The velocity at the end of a substep: d / h exp(-c h). The includer declares `uniforms`.
vec3 endVelocity(vec3 d) {
    return d / uniforms.substep * uniforms.drag_factor;
}

// Folds are found anew before the next substep, from none.
#if defined(UNFOLDS) && !defined(SMALL_GROUP)
layout(std430, binding = kEndedFoldsBinding) writeonly buffer EndedFolds { uint endedFolds[]; };
void endFold(uint v) { endedFolds[v] = 0u; }
#else
void endFold(uint v) {}
#endif
