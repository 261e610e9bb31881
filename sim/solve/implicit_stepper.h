#pragma once

#include "gpu/program.h"
#include "sim/base/params.h"
#include "sim/solve/collisions.h"
#include "sim/solve/implicit/implicit_body.h"
#include "sim/solve/implicit/step_choice.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// Time steps of two linearly implicit stages each: ImplicitReference in floats, in the same order,
/// with results that do not depend on the number of threads.
class ImplicitStepper {
  public:
    /// Both must outlive it. Compiles the kernels: throws gpu::ShaderError.
    ImplicitStepper(SolverBody& body, Collisions& collisions);

    /// Takes a body and its parameters, from which the steps are prepared; anew whenever either or
    /// the pins change, and after steps of another kind. Throws gpu::OutOfMemory.
    void setBody(const BodyModel& model, const Params& params, const ImplicitStep& step,
                 std::span<const std::uint32_t> pinned);
    /// Changes length and iterations of the coming steps, of what was taken with these parameters.
    void setStep(const Params& params, const ImplicitStep& step);
    /// What contacts push and hold back between steps, row by row; of vertices behind the last:
    /// nothing. Waits for the GPU.
    std::vector<shared::vec4> slips() const;
    void setSlips(const std::vector<shared::vec4>& slips);
    /// Does one step, the one with this number in the time step. Masses must be fresh, and contacts
    /// searched for. `heldMove`: whether any vertex without a mass has a velocity, with which it is
    /// moved. `portion` does each part of it, the next one after that, between which others may use
    /// OpenGL.
    template <class Portion>
    void run(std::uint32_t number, bool heldMove, Portion&& portion) {
        portion([&] { begin(number); });
        portion([&] {
            answerPressure();
            driftBy(heldMove);
        });
        portion([&] { solveStage(false); });
        portion([&] { solveStage(true); });
        portion([&] { end(heldMove); });
    }
    void run(std::uint32_t number = 0, bool heldMove = false) {
        run(number, heldMove, [](auto&& part) { part(); });
    }

  private:
    void bindVectors() const;
    void bindLists() const;
    void runGroups(const gpu::Program& kernel, std::uint32_t groups, std::uint32_t slot,
                   std::uint32_t second = 0, std::uint32_t third = 0);
    void meet();
    const gpu::Program& meetBesideFolds();
    void meetObstacles(const ObstacleContact& obstacles, const gpu::Program& kernel);
    void press();
    std::uint32_t firstPull() const;
    /// The first row of an edge that presses; 0: none does.
    std::uint32_t pressedRows() const;
    void addLoads(bool second);
    void pull(double stageEnd, bool begins);
    void driftBy(bool heldMove);
    void bindContacts() const;
    void linearise();
    void makeFactors(std::uint32_t type);
    void begin(std::uint32_t number);
    void answerPressure();
    void answerByModes(bool ofPressure, std::uint32_t slot);
    void solveStage(bool second);
    void end(bool heldMove);

    SolverBody& body_;
    Collisions& collisions_;
    ImplicitBody own_;
    shared::ImplicitUniforms uniforms_{};
    gpu::Buffer uniformBuffer_;
    std::uint32_t iterations_ = 0;
    std::uint32_t number_ = 0;  ///< of the step
    bool drifts_ = true;        ///< the drift may not be zero
    /// Of where a step begins.
    struct MatrixKernels {
        explicit MatrixKernels(const SolverBody& body);
        std::array<gpu::Program, kConstraintTypes> factors;
        gpu::Program blocks, forces, turns, volume;
    } make_;
    struct ContactKernels {
        explicit ContactKernels(const SolverBody& body);
        gpu::Program meet, meetBoxes, pulls, rows, startReach, reach, hold, carry;
    } contact_;
    /// Of a blade that pushes or presses, compiled when the first one does.
    struct BladeKernels {
        explicit BladeKernels(const SolverBody& body);
        gpu::Program meet, load, press, pressLoad;
    };
    std::optional<BladeKernels> blade_;
    std::optional<gpu::Program> meetBesideFolds_;  ///< compiled when first needed
    struct PressureKernels {
        explicit PressureKernels(const SolverBody& body);
        gpu::Program patches, coarse, product;
    } press_;
    /// Of a body with regions, compiled when the first one comes.
    struct RegionKernels {
        explicit RegionKernels(const SolverBody& body);
        gpu::Program restrict, regions, pressCoarse, coarse;
    };
    std::optional<RegionKernels> regions_;
    struct StageKernels {
        explicit StageKernels(const SolverBody& body);
        std::array<gpu::Program, 2> begin;  ///< of the first and the second stage
        gpu::Program startProduct, startPatches, coarse, product, patches, leave, turning, spin,
            end;
    } stage_;
};

}  // namespace kerf
