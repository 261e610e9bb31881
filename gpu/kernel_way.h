#pragma once

#include "gpu/context.h"

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

}  // namespace kerf::gpu
