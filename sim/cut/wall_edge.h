#pragma once

#include <algorithm>

namespace kerf {

/// The default edge length of walls [m]: the mean of the skin, at most a twelfth of the body's
/// diagonal, so that coarse bodies get walls finer than their skin.
inline double wallEdgeFor(double meanEdge, double diagonal) {
    constexpr double kEdgesPerDiagonal = 12;
    return std::min(meanEdge, diagonal / kEdgesPerDiagonal);
}

}  // namespace kerf
