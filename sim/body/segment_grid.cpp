#include "sim/body/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

std::vector<int>& SegmentGrid::at(const Cell& cell) {
    return cells_[(static_cast<std::size_t>(cell[2]) * perAxis_ + cell[1]) * perAxis_ + cell[0]];
}

// From cell to cell through the nearest side (Amanatides and Woo 1987).
void SegmentGrid::add(int id, const Vec3& from, const Vec3& to) {
    Cell cell = cellOf(from);
    const Cell last = cellOf(to);
    const Vec3 along = to - from;
    at(cell).push_back(id);
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
        at(cell).push_back(id);
        ++entries_;
    }
}

void SegmentGrid::find(const Bounds& box, std::vector<int>& found) const {
    const Cell low = cellOf(box.low - kPad * cellSize_);
    const Cell high = cellOf(box.high + kPad * cellSize_);
    for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int x = low[0]; x <= high[0]; ++x) {
                const auto& cell =
                    cells_[(static_cast<std::size_t>(z) * perAxis_ + y) * perAxis_ + x];
                found.insert(found.end(), cell.begin(), cell.end());
            }
        }
    }
}

}  // namespace kerf
