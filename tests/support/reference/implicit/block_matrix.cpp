#include "tests/support/reference/implicit/block_matrix.h"

namespace kerf {

BlockMatrix::BlockMatrix(const BodyModel& model) {
    std::vector<std::vector<std::uint32_t>> rows(model.restPositions.size());
    for (std::uint32_t v = 0; v < rows.size(); ++v) {
        rows[v].push_back(v);
    }
    forEachType(model, [&](auto, const auto& constraints) {
        for (const auto& constraint : constraints) {
            for (const std::uint32_t i : verticesOf(constraint)) {
                for (const std::uint32_t j : verticesOf(constraint)) {
                    rows[i].push_back(j);
                }
            }
        }
    });
    starts_.push_back(0);
    for (auto& row : rows) {
        std::ranges::sort(row);
        row.erase(std::unique(row.begin(), row.end()), row.end());
        columns_.insert(columns_.end(), row.begin(), row.end());
        starts_.push_back(columns_.size());
    }
    clear();
}

void BlockMatrix::clear() {
    blocks_.assign(columns_.size(), Eigen::Matrix3d::Zero());
}

std::size_t BlockMatrix::find(std::uint32_t row, std::uint32_t column) const {
    const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(starts_[row]);
    const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(starts_[row + 1]);
    return static_cast<std::size_t>(std::lower_bound(begin, end, column) - columns_.begin());
}

void BlockMatrix::add(std::uint32_t row, std::uint32_t column, const Eigen::Matrix3d& block) {
    blocks_[find(row, column)] += block;
}

Vectors BlockMatrix::times(std::span<const Vec3> x) const {
    Vectors y(x.size());
    for (std::size_t row = 0; row < y.size(); ++row) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = starts_[row]; k < starts_[row + 1]; ++k) {
            sum += blocks_[k] * x[columns_[k]];
        }
        y[row] = sum;
    }
    return y;
}

}  // namespace kerf
