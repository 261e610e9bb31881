#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/math.h"

namespace kerf {

/// Numbered segments by the cells of a grid that they pass. Segments are never removed: callers
/// must check those that they find.
class SegmentGrid {
  public:
    SegmentGrid() = default;
    /// `box` should hold the segments (others are filed at its border); `count`: about how many.
    SegmentGrid(const Bounds& box, int count);

    void add(int id, const Vec3& from, const Vec3& to);
    /// The ids of segments that pass a cell of one of the boxes. Ascending.
    std::vector<int> find(std::span<const Bounds> boxes) const;
    /// Whether it has grown until a new grid would be much smaller.
    bool overfull() const { return entries_ > kMostGrowth * entriesExpected_; }

  private:
    using Cell = std::array<int, 3>;
    static constexpr long kMostGrowth = 3;

    Cell cellOf(const Vec3& p) const;
    int indexOf(const Cell& cell) const {
        return (cell[2] * perAxis_ + cell[1]) * perAxis_ + cell[0];
    }
    void addCells(const Bounds& box, std::vector<int>& cells) const;

    Bounds box_;
    int perAxis_ = 1;
    Vec3 cellSize_ = Vec3::Ones();
    std::vector<std::vector<int>> cells_;
    long entries_ = 0;
    long entriesExpected_ = 0;
};

}  // namespace kerf
