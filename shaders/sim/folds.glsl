#pragma once
// How far the skin at a vertex is folded, 0 to 1, when the substep begins. Where it is, constraints
// are not damped but bounded (a damped sweep gives way to a load 1 + gamma times as far), the floor
// does not rub, and neither the walls of a slit nor others of the same piece touch: friction holds
// what the springs that unfold press onto the floor, and a wall that has turned over is caught
// behind them. Those springs are damped themselves. Kernels with UNFOLDS are compiled for steps
// that unfold; to others nothing is folded.
#if !defined(UNFOLDS)
float foldAt(uint v) { return 0.0; }
#elif defined(SMALL_GROUP)
float foldAt(uint v);  // small_body_state.glsl
#else
layout(binding = kFoldsUnit) uniform usamplerBuffer folds;
float foldAt(uint v) { return uintBitsToFloat(texelFetch(folds, int(v)).x); }
#endif

float foldAt(uvec4 v) {
    return max(max(foldAt(v.x), foldAt(v.y)), max(foldAt(v.z), foldAt(v.w)));
}
