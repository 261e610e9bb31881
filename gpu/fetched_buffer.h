#pragma once

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/kernel_way.h"

namespace kerf::gpu {

/// Binds a buffer that kernels compiled for `way` read by fetch() (shaders/sim/fetch.glsl). Throws
/// OutOfMemory if the driver's texture buffers are too small.
inline void bindFetched(const Buffer& buffer, std::uint32_t unit, TexelFormat format,
                        KernelWay way) {
    buffer.bindTexels(unit, format);
    if (way == KernelWay::images) {
        buffer.bindImage(unit, format);
    }
}

}  // namespace kerf::gpu
