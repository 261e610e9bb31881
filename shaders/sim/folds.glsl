#pragma once
// How far the skin at a vertex is folded, 0 to 1, when the step begins. Where it is, the floor does
// not rub, and neither the walls of a slit nor others of the same piece touch: friction holds what
// the springs that unfold press onto the floor, and a wall that has turned over is caught behind
// them. Kernels with UNFOLDS are compiled for steps that unfold; to others nothing is folded.
#ifdef UNFOLDS
layout(binding = kFoldsUnit) uniform usamplerBuffer folds;
float foldAt(uint v) { return uintBitsToFloat(texelFetch(folds, int(v)).x); }
#else
float foldAt(uint v) { return 0.0; }
#endif

float foldAt(uvec4 v) {
    return max(max(foldAt(v.x), foldAt(v.y)), max(foldAt(v.z), foldAt(v.w)));
}
