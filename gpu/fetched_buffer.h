#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "gpu/program.h"

namespace kerf::gpu {

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
