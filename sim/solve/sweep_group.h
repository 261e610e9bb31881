#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "gpu/kernel_way.h"
#include "gpu/program.h"
#include "sim/body/body_model.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// Mesa's llvmpipe silently ends all loops of a thread after 65,535 iterations in total per
/// dispatch. Some are reserved for what a dispatch does once.
inline constexpr std::size_t kMostTurns = 64000;

/// The most iterations of all loops of a thread of sweeps.comp in one sweep, by a group of so many:
/// how often their conditions are evaluated. An upper bound, checked by SweepGroupTest.
std::size_t mostTurnsOfSweep(const BodyModel& model, std::uint32_t threads);

/// Sweeps of plain PBD over a body that meets nothing but the floor, many in a dispatch: one work
/// group runs the phases of the other kernels with the same arithmetic.
class SweepGroup {
  public:
    /// A new or changed body.
    void setBody(const BodyModel& model);
    /// Whether one group can sweep it.
    bool fits() const { return sweepsAtOnce_ > 0; }
    /// One step: all sweeps of the uniforms. The first compiles the kernel: throws
    /// gpu::ShaderError.
    void step(SolverBody& body);

  private:
    static std::uint32_t threadsFor(gpu::KernelWay way);
    void bind(const SolverBody& body) const;

    gpu::KernelWay way_ = gpu::kernelWay();
    std::uint32_t threads_ = threadsFor(way_);
    std::uint32_t sweepsAtOnce_ = 0;  ///< 0: the body does not fit
    std::optional<gpu::Program> kernel_;
};

}  // namespace kerf
