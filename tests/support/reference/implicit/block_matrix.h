#pragma once

#include <Eigen/Core>

#include "sim/body/body_model.h"

namespace kerf {

using Vectors = std::vector<Vec3>;  ///< of all vertices

/// A matrix of 3x3 blocks, with one where a constraint joins two vertices.
class BlockMatrix {
  public:
    explicit BlockMatrix(const BodyModel& model);

    void clear();
    void add(std::uint32_t row, std::uint32_t column, const Eigen::Matrix3d& block);
    /// Its product with `x`.
    Vectors times(std::span<const Vec3> x) const;

  private:
    std::size_t find(std::uint32_t row, std::uint32_t column) const;

    std::vector<std::size_t> starts_;
    std::vector<std::uint32_t> columns_;  ///< ascending in each row
    std::vector<Eigen::Matrix3d> blocks_;
};

}  // namespace kerf
