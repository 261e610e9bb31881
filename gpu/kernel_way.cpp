#include "gpu/kernel_way.h"

#include <cstdlib>

namespace kerf::gpu {
namespace {

/// "" where it is not set.
std::string_view wanted() {
    const char* name = std::getenv("KERF_KERNELS");
    return name == nullptr ? "" : name;
}

std::optional<KernelWay> kernelWayNamed(std::string_view name) {
    return name == "images"   ? std::optional(KernelWay::images)
           : name == "shared" ? std::optional(KernelWay::shared)
                              : std::nullopt;
}

}  // namespace

KernelWay kernelWay() {
    const auto suitable = [] {
        return queryDevice().software ? KernelWay::images : KernelWay::shared;
    };
    const std::optional<KernelWay> named = kernelWayNamed(wanted());
    return named ? *named : suitable();
}

const char* problemWithKernelWay() {
    return wanted().empty() || kernelWayNamed(wanted())
               ? nullptr
               : "The variable KERF_KERNELS names no way that kernels can take; set it to images "
                 "or shared, or unset it.";
}

}  // namespace kerf::gpu
