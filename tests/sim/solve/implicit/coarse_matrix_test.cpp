#include "sim/solve/implicit/coarse_matrix.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

using Eigen::MatrixXd;
constexpr int kRows = CoarseMatrix::kRows;

/// A chain of blocks, all linked to the first one, too.
CoarseMatrix chainOf(int count) {
    CoarseMatrix matrix(count);
    for (int i = 0; i < count; ++i) {
        matrix.at(i, i) = 5 * CoarseMatrix::Block::Identity();
        matrix.at(i, 0) += 0.1 * CoarseMatrix::Block::Ones();
        if (i > 1) {
            matrix.at(i, i - 1) = 0.1 * CoarseMatrix::Block::Constant(i).cwiseInverse();
            matrix.at(i, i - 1).triangularView<Eigen::StrictlyUpper>().setZero();
        }
    }
    return matrix;
}

TEST(CoarseMatrixTest, TimesItsInverseIsOne) {
    constexpr int kCount = 9;
    CoarseMatrix chain = chainOf(kCount);
    MatrixXd dense(kRows * kCount, kRows * kCount);
    const auto [places, inverse] = chainOf(kCount).invert();
    for (int i = 0; i < kCount; ++i) {
        for (int j = 0; j <= i; ++j) {
            dense.block<kRows, kRows>(kRows * places[i], kRows * places[j]) = chain.at(i, j);
            dense.block<kRows, kRows>(kRows * places[j], kRows * places[i]) =
                chain.at(i, j).transpose();
        }
    }
    EXPECT_TRUE((dense * inverse).isIdentity(1e-12));
    EXPECT_EQ(inverse, inverse.transpose());
}

}  // namespace
}  // namespace kerf
