#pragma once

#include "gpu/buffer.h"
#include "gpu/context.h"
#include "gpu/program.h"

namespace kerf::gpu {

/// How kernels read what others write, and how many threads share sums. Both give the same bits.
enum class KernelWay : std::uint8_t {
    images,  ///< as images, in groups of eight: fast where the driver computes on the processor
    shared,  ///< as texels, through shared memory, in groups of hundreds: fast on GPUs
};

/// The way set by the variable KERF_KERNELS, or else the best one for the driver of the current
/// context.
KernelWay kernelWay();
/// The problem with KERF_KERNELS, in a sentence; null for none.
const char* problemWithKernelWay();

/// A kernel that reads such buffers by fetch(). Throws ShaderError.
inline Program fetchingKernel(const std::string& path, KernelWay way, Defines defines = {}) {
    if (way == KernelWay::images) {
        defines.emplace_back("LOAD_IMAGES", "1");
    }
    return Program::compute(path, defines);
}

/// Binds a buffer that kernels compiled for `way` read by fetch() (shaders/sim/base/fetch.glsl).
/// Throws OutOfMemory if the driver's texture buffers are too small.
inline void bindFetched(const Buffer& buffer, std::uint32_t unit, TexelFormat format,
                        KernelWay way) {
    buffer.bindTexels(unit, format);
    if (way == KernelWay::images) {
        buffer.bindImage(unit, format);
    }
}

}  // namespace kerf::gpu
