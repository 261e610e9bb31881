#include "sim/solve/implicit/coarse_matrix.h"

namespace kerf {

CoarseMatrix::Inverse CoarseMatrix::invert() {
    const std::vector<Pivot> pivots = eliminate();
    Inverse inverse{std::vector<int>(count_), {}};
    Eigen::MatrixXd& matrix = inverse.matrix;
    matrix.resize(kRows * count_, kRows * count_);
    for (int k = count_ - 1; k >= 0; --k) {
        const auto& [row, later, own, shares] = pivots[k];
        inverse.places[row] = k;
        const Eigen::Index first = kRows * (k + 1);
        const Eigen::Index height = matrix.rows() - first;
        Column column = Column::Zero(height, kRows);
        Block diagonal = own;
        for (std::size_t a = 0; a < later.size(); ++a) {
            column.noalias() -=
                matrix.block(first, kRows * inverse.places[later[a]], height, kRows) *
                shares.middleRows<kRows>(kRows * a);
        }
        for (std::size_t a = 0; a < later.size(); ++a) {
            diagonal.noalias() -=
                shares.middleRows<kRows>(kRows * a).transpose() *
                column.middleRows<kRows>(kRows * inverse.places[later[a]] - first);
        }
        matrix.block<kRows, kRows>(kRows * k, kRows * k) = diagonal.selfadjointView<Eigen::Lower>();
        matrix.block(first, kRows * k, height, kRows) = column;
        matrix.block(kRows * k, first, kRows, height) = column.transpose();
    }
    return inverse;
}

/// Rows with the fewest links first.
std::vector<CoarseMatrix::Pivot> CoarseMatrix::eliminate() {
    Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> linked(count_, count_);
    for (int i = 0; i < count_; ++i) {
        for (int j = 0; j <= i; ++j) {
            linked(i, j) = linked(j, i) = !at(i, j).isZero(0);
        }
    }
    std::vector<int> left(count_);
    std::iota(left.begin(), left.end(), 0);
    std::vector<Pivot> pivots;
    pivots.reserve(count_);
    while (!left.empty()) {
        const auto least =
            std::ranges::min_element(left, {}, [&](int i) { return linked.col(i).count(); });
        const int row = *least;
        left.erase(least);
        std::vector<int> later;
        std::ranges::copy_if(left, std::back_inserter(later),
                             [&](int j) { return linked(j, row); });
        for (const int j : later) {
            linked.col(j) = linked.col(j) || linked.col(row);
        }
        linked.row(row).setConstant(false);
        pivots.push_back(eliminate(row, std::move(later)));
    }
    return pivots;
}

CoarseMatrix::Pivot CoarseMatrix::eliminate(int row, std::vector<int> later) {
    const int count = static_cast<int>(later.size());
    Column links(kRows * count, kRows);
    for (int a = 0; a < count; ++a) {
        auto link = links.middleRows<kRows>(kRows * a);
        if (later[a] > row) {
            link = at(later[a], row);
        } else {
            link = at(row, later[a]).transpose();
        }
    }
    const Block inverse = at(row, row).llt().solve(Block::Identity());
    const Column shares = links * inverse;
    Column change(links.rows(), kRows);
    for (int b = 0; b < count; ++b) {
        const int height = kRows * (count - b);
        change.topRows(height).noalias() =
            shares.bottomRows(height) * links.middleRows<kRows>(kRows * b).transpose();
        for (int a = b; a < count; ++a) {
            at(later[a], later[b]) -= change.middleRows<kRows>(kRows * (a - b));
        }
    }
    return {row, std::move(later), inverse, shares};
}

}  // namespace kerf
