#include "sim/body/segment_grid.h"

#include <algorithm>
#include <cmath>

#include "sim/base/sort_unique.h"

namespace kerf {

namespace {

constexpr int kMostPerAxis = 32;
constexpr double kPad = 1e-6;  // of a cell: a step along a segment may round past a corner

}  // namespace

SegmentGrid::SegmentGrid(const Bounds& box, int count) : box_(box) {
    perAxis_ = std::clamp(static_cast<int>(std::cbrt(count) / 2), 2, kMostPerAxis);
    cellSize_ = (box.high - box.low).cwiseMax(1e-30) / perAxis_;
    cells_.resize(static_cast<std::size_t>(perAxis_) * perAxis_ * perAxis_);
    entriesExpected_ = 2L * perAxis_ * std::max(count, 100);
}

SegmentGrid::Cell SegmentGrid::cellOf(const Vec3& p) const {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (p[axis] - box_.low[axis]) / cellSize_[axis];
        cell[axis] = static_cast<int>(std::clamp(std::floor(place), 0.0, perAxis_ - 1.0));
    }
    return cell;
}

// From cell to cell through the nearest side (Amanatides and Woo 1987).
void SegmentGrid::add(int id, const Vec3& from, const Vec3& to) {
    Cell cell = cellOf(from);
    const Cell last = cellOf(to);
    const Vec3 along = to - from;
    cells_[indexOf(cell)].push_back(id);
    ++entries_;
    for (int steps = 0; cell != last && steps < 3 * perAxis_; ++steps) {
        int axis = -1;
        double nearest = 1e300;
        for (int k = 0; k < 3; ++k) {
            if (cell[k] == last[k]) {
                continue;
            }
            const double side =
                box_.low[k] + cellSize_[k] * (cell[k] + (last[k] > cell[k] ? 1 : 0));
            const double reached = along[k] != 0 ? (side - from[k]) / along[k] : 0.0;
            if (axis < 0 || reached < nearest) {
                nearest = reached;
                axis = k;
            }
        }
        cell[axis] += last[axis] > cell[axis] ? 1 : -1;
        cells_[indexOf(cell)].push_back(id);
        ++entries_;
    }
}

std::vector<int> SegmentGrid::find(std::span<const Bounds> boxes) const {
    std::vector<int> cells;
    for (const Bounds& box : boxes) {
        addCells(box, cells);
    }
    sortUnique(cells);
    std::vector<int> found;
    for (const int cell : cells) {
        found.insert(found.end(), cells_[cell].begin(), cells_[cell].end());
    }
    sortUnique(found);
    return found;
}

/// Appends those that the box meets.
void SegmentGrid::addCells(const Bounds& box, std::vector<int>& cells) const {
    const Cell low = cellOf(box.low - kPad * cellSize_);
    const Cell high = cellOf(box.high + kPad * cellSize_);
    for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int x = low[0]; x <= high[0]; ++x) {
                cells.push_back(indexOf({x, y, z}));
            }
        }
    }
}

}  // namespace kerf
