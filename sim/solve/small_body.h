#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "gpu/program.h"
#include "sim/body/body_model.h"
#include "sim/solve/collisions.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// Mesa's llvmpipe silently ends all loops of a thread after 65,535 iterations in total per
/// dispatch. Some are reserved for what a dispatch does once.
inline constexpr std::size_t kMostTurns = 64000;
inline constexpr std::size_t kSparedTurns = 65535 - kMostTurns;

/// How a group processes a body: `threads` of its threads run side by side, and loop as often as
/// the slowest. Each has a range of the vertices (see small_body_state.glsl).
struct GroupShape {
    std::uint32_t threads;
    std::uint32_t sideBySide;
};

/// The most iterations of all loops of a thread of small_body.comp in one sweep of plain PBD: how
/// often their conditions are evaluated. SolverLoops.* counts them.
std::size_t turnsOfSweep(const BodyModel& model, const GroupShape& group);

/// The most iterations of these loops in one substep of a body of `blocks` blocks of a page each.
std::size_t turnsOfSubstep(const BodyModel& model, std::size_t blocks, const GroupShape& group);

/// The most iterations that contact adds to that, and that what unfolds does.
std::size_t turnsOfContact(const BodyModel& model, const GroupShape& group);
std::size_t turnsOfUnfolding(const BodyModel& model, const GroupShape& group);
/// And contact with so many boxes.
std::size_t turnsOfBoxes(const BodyModel& model, std::size_t boxes, const GroupShape& group);

/// A run of substeps. A substep begins with the prediction and ends with floor and velocities, with
/// collisions in between.
struct SubstepRun {
    std::uint32_t begins = 0;  ///< how many substeps begin
    bool firstIsOpen = false;  ///< first ends a substep that began before
    bool leavesOpen = false;   ///< the last one does not end
};

/// Sweeps of plain PBD: from `first` up to, not including, `end`.
struct SweepRun {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
};

/// Substeps of a small body in one dispatch: one work group runs the phases of the other kernels
/// with the same arithmetic and sums in the same order.
class SmallBodySolver {
  public:
    /// `threads` of the group, where it takes the shared way.
    explicit SmallBodySolver(gpu::KernelWay way = gpu::kernelWay(),
                             std::uint32_t threads = gpu::threadsOfGroup(gpu::queryDevice()))
        : way_(way), threads_(threads) {}
    gpu::KernelWay way() const { return way_; }

    /// A new or changed body. Whether sweeps fit is computed from every vertex, for large bodies
    /// only on request.
    void setBody(const BodyModel& model, std::span<const shared::BlockRecord> blocks,
                 bool asksForSweeps);
    /// Whether one group can solve it.
    bool fits() const { return substepsAtOnce() > 0; }
    /// How many substeps may begin in one dispatch.
    std::uint32_t substepsAtOnce() const { return atOnce(substepTurns_); }
    /// The most sweeps of plain PBD in a dispatch, which one group of llvmpipe can do for larger
    /// bodies too; 0 if it can't.
    std::uint32_t sweepsAtOnce() const { return atOnce(sweepTurns_); }
    /// Turns of loops, at most, in each of those (see turnsOfSubstep()); 0 where there are none.
    std::size_t turnsOfSubstep() const { return substepTurns_; }
    std::size_t turnsOfSweep() const { return sweepTurns_; }
    std::size_t turnsOfTouching(bool folded, std::size_t boxes) const {
        const std::size_t turns = folded ? foldedTurns_ : touchTurns_;
        return turns == 0 || boxes == 0 ? turns : turns + turnsBesideBoxes_ + boxes * turnsOfBox_;
    }

    /// Whether it may be too much for one thread of llvmpipe.
    bool large() const { return large_; }

    /// The folds of the skin at each vertex (Unfolding::folds()) in the coming substeps; null, the
    /// default, if not folded.
    void setFolds(const gpu::Buffer* folds) { folds_ = folds; }

    /// The same where contact comes between, with so many boxes too, and folds are unfolded before;
    /// 0: they can't.
    std::uint32_t touchingSubstepsAtOnce(std::size_t boxes) const {
        return atOnce(turnsOfTouching(folds_ != nullptr, boxes));
    }

    /// One dispatch. The first compiles the kernel: throws gpu::ShaderError.
    void run(const SolverBody& body, const SubstepRun& run);
    /// That many whole substeps, with contact (Collisions::answersInOneGroup()) before the end of
    /// each, and where there are folds with what unfolds them (Unfolding) before its beginning.
    void run(const SolverBody& body, std::uint32_t substeps, const Collisions& collisions);
    void run(const SolverBody& body, const SweepRun& run);

  private:
    static std::uint32_t atOnce(std::size_t turns) {
        return turns == 0 ? 0 : static_cast<std::uint32_t>(kMostTurns / turns);
    }
    std::uint32_t groupSize() const { return way_ == gpu::KernelWay::shared ? threads_ : 8; }
    /// So many that all substeps of most bodies fit into a dispatch.
    std::uint32_t touchingGroupSize() const {
        return way_ == gpu::KernelWay::shared ? threads_ : 64;
    }
    std::uint32_t groupSizeOfSweeps() const;
    gpu::Program compile(std::uint32_t threads, gpu::Defines defines) const;
    void setSweeps(const BodyModel& model);
    void run(const SolverBody& body, const gpu::DispatchNumbers& numbers,
             const Collisions* collisions);
    void bind(const SolverBody& body) const;

    gpu::KernelWay way_;
    std::uint32_t threads_;
    /// By what contact is among the phases (none, itself, boxes), and whether the skin is folded.
    std::array<std::array<std::optional<gpu::Program>, 2>, 3> kernels_;
    std::optional<gpu::Program> sweepKernel_;
    std::optional<gpu::Program> largeSweepKernel_;
    const gpu::Buffer* folds_ = nullptr;
    gpu::Buffer parts_;
    std::uint32_t blocks_ = 0;
    std::size_t substepTurns_ = 0;
    std::size_t touchTurns_ = 0;
    std::size_t foldedTurns_ = 0;
    std::size_t turnsBesideBoxes_ = 0;
    std::size_t turnsOfBox_ = 0;
    std::size_t sweepTurns_ = 0;
    bool large_ = false;  ///< more than kSmallBodyVertices
};

}  // namespace kerf
