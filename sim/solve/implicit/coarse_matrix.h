#pragma once

#include <Eigen/Dense>

namespace kerf {

/// A symmetric positive definite matrix in blocks, some of which are 0.
class CoarseMatrix {
  public:
    static constexpr int kRows = 12;  ///< of a block
    using Block = Eigen::Matrix<double, kRows, kRows>;
    using Column = Eigen::Matrix<double, Eigen::Dynamic, kRows>;

    explicit CoarseMatrix(int count)
        : count_(count), blocks_(count * (count + 1) / 2, Block::Zero()) {}
    int count() const { return count_; }
    /// Of row i and column j <= i.
    Block& at(int i, int j) { return blocks_[i * (i + 1) / 2 + j]; }

    /// Its blocks in another order, inverted. Symmetric to the last bit.
    struct Inverse {
        std::vector<int> places;  ///< of each row of blocks
        Eigen::MatrixXd matrix;
    };
    /// Leaves the matrix undefined. Takes less time the more blocks are 0.
    Inverse invert();

  private:
    /// A row of blocks that was eliminated.
    struct Pivot {
        int row = 0;
        std::vector<int> later;  ///< rows that it was linked to then
        Block inverse;
        Column shares;  ///< for each of `later`, how much of it was taken from that
    };
    std::vector<Pivot> eliminate();
    Pivot eliminate(int row, std::vector<int> later);

    int count_ = 0;
    std::vector<Block> blocks_;
};

}  // namespace kerf
