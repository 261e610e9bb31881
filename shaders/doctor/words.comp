// For kerf doctor: writes words of a buffer, or shows them as one kind of reader sees them.
//   OF_STORAGE, OF_TEXELS, OF_UNIFORM, OF_INDIRECT: that reader; none: writes
#include "sim/base/numbers.glsl"  // x: the first word, y: how many, z: what is written

layout(local_size_x = 128) in;
layout(std430, binding = 0) buffer Words { uint words[]; };
#ifdef OF_STORAGE
layout(std430, binding = 1) readonly buffer From { uint from[]; };
#endif
#ifdef OF_TEXELS
layout(binding = 0) uniform usamplerBuffer from;
#endif

void main() {
    const uint i = gl_GlobalInvocationID.x;
#ifdef OF_UNIFORM
    if (i == 0u) {  // the block is what is looked at
        words[0] = numbers.x;
        words[1] = numbers.y;
        words[2] = numbers.z;
        words[3] = numbers.w;
    }
#elif defined(OF_INDIRECT)
    if (gl_LocalInvocationIndex == 0u) {
        atomicMax(words[0], gl_WorkGroupID.x + 1u);
        atomicMax(words[1], gl_WorkGroupID.y + 1u);
        atomicMax(words[2], gl_WorkGroupID.z + 1u);
    }
#else
    if (i >= numbers.y) return;
#ifdef OF_STORAGE
    words[i] = from[i];
#elif defined(OF_TEXELS)
    words[i] = texelFetch(from, int(i)).x;
#else
    words[numbers.x + i] = numbers.z;
#endif
#endif
}
