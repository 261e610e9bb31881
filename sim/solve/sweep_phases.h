#pragma once

#include <array>
#include <cstdint>

#include "gpu/program.h"
#include "sim/solve/solver_body.h"

namespace kerf {

/// The phases of a step of plain PBD except contact, in a dispatch or two each; each ends with a
/// storage barrier, and does nothing if its part of the uniforms is off.
class SweepPhases {
  public:
    /// The body must outlive it. Compiles the kernels: throws gpu::ShaderError.
    explicit SweepPhases(SolverBody& body);

    void predictAndStretch();
    /// Solves the edges without a prediction: in all sweeps except the first.
    void stretchAgain();
    /// Solves the constraints of a type other than edges.
    void solve(std::uint32_t type);
    void pull();
    void collideFloor();
    /// The floor and the end of the step.
    void finish();

  private:
    void bindLists(std::uint32_t type) const;

    SolverBody& body_;
    gpu::Program stretch_, stretchAgain_;
    /// By type of constraint, except edges.
    std::array<gpu::Program, kConstraintTypes> solve_, gather_;
    gpu::Program pull_, floor_, finish_;
};

}  // namespace kerf
