// What the phases of touches.glsl read and write, for kernels of one phase.
#include "blade_records.h"
#include "sim/base/numbers.glsl"
#include "sim/boxes/uniforms.glsl"
layout(local_size_x = kGroupSize) in;
layout(std430, binding = kBoxPositionsBinding) buffer Positions { vec4 positions[]; };
layout(std430, binding = kBoxDisplacementBinding) buffer Displacement { vec4 displacement[]; };
layout(std430, binding = kBoxTrianglesBinding) readonly buffer Triangles { uvec4 triangles[]; };
#ifdef BLADE
layout(std430, binding = kBoxBoxesBinding) readonly buffer Blades { BladeRecord blades[]; };
BladeRecord bladeNow() { return blades[numbers.x]; }
#else
layout(std430, binding = kBoxBoxesBinding) readonly buffer Boxes { BoxRecord boxes[]; };
BoxRecord boxAt(uint b) { return boxes[b]; }
#endif
layout(std430, binding = kBoxRecordsBinding) buffer Touches { BoxTouch touches[]; };
layout(std430, binding = kBoxSharesBinding) buffer Shares { uint shares[]; };
layout(std430, binding = kBoxSumsBinding) buffer Sums { int sums[]; };

vec4 positionOf(uint v) { return positions[v]; }
vec4 displacementOf(uint v) { return displacement[v]; }
void setPosition(uint v, vec4 x) { positions[v] = x; }
void setDisplacement(uint v, vec4 d) { displacement[v] = d; }
uvec4 triangleAt(uint t) { return triangles[t]; }
void takeShare(uint v, uint share) { atomicAdd(shares[v], share); }
uint shareTaken(uint v) { return shares[v]; }
void clearShare(uint v) { shares[v] = 0u; }
