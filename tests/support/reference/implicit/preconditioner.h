#pragma once

#include "sim/solve/implicit/rest_inverse.h"
#include "tests/support/reference/implicit/block_matrix.h"

namespace kerf {

/// The inverse at rest, turned with the body: z = sum of the patches' and the aggregates' answers.
class Preconditioner {
  public:
    /// What it names must outlive it.
    Preconditioner(const BodyModel& model, const VertexGroups& groups, const RestInverse& inverse,
                   std::span<const double> masses);

    /// Turns the parts to where their vertices are.
    void turn(std::span<const Vec3> positions);
    Vectors apply(std::span<const Vec3> residual) const;

  private:
    void addPatches(std::span<const Vec3> residual, Vectors& out) const;
    void addAggregates(std::span<const Vec3> residual, Vectors& out) const;

    const VertexGroups& groups_;
    const RestInverse& inverse_;
    std::span<const double> masses_;
    Vectors rest_;
    std::vector<Eigen::Matrix3d> patchTurns_, aggregateTurns_;
};

}  // namespace kerf
