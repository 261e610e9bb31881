#pragma once

#include "sim/solve/implicit/rest_inverse.h"
#include "tests/support/reference/implicit/block_matrix.h"

namespace kerf {

/// The inverse at rest, turned with the body: z = sum of the answers of the patches, the regions,
/// and where those have several, the aggregates.
class Preconditioner {
  public:
    /// What it names must outlive it.
    Preconditioner(const BodyModel& model, const VertexGroups& groups, const RestInverse& inverse,
                   std::span<const double> masses);

    /// Turns the parts to where their vertices are.
    void turn(std::span<const Vec3> positions);
    Vectors apply(std::span<const Vec3> residual) const;

  private:
    using Modes = Eigen::Matrix<double, AggregateFrame::kModes, 1>;
    /// A group that moves by its modes.
    struct Moved {
        const VertexGroup& vertices;
        const AggregateFrame& frame;
        const Eigen::Matrix3d& turn;
    };
    void addPatches(std::span<const Vec3> residual, Vectors& out) const;
    void addAggregates(std::span<const Vec3> residual, Vectors& out) const;
    void addRegions(std::span<const Vec3> residual, Vectors& out) const;
    Modes residualOf(const Moved& group, std::span<const Vec3> residual) const;
    void addMotion(const Moved& group, const Modes& modes, Vectors& out) const;

    const VertexGroups& groups_;
    const RestInverse& inverse_;
    std::span<const double> masses_;
    Vectors rest_;
    std::vector<VertexGroup> regions_;
    std::vector<Eigen::Matrix3d> patchTurns_, aggregateTurns_, regionTurns_;
};

}  // namespace kerf
