#pragma once

#include "sim/cut/plan/curves/outline.h"

namespace kerf::test {

/// The outline of a wall drawn by hand in the layout plane, of wall nodes.
struct DrawnOutline {
    using Points = std::vector<Vec2>;

    cut::Outline outline;
    cut::CutCurves curves;  ///< its nodes, at (x - 2, 2 - y, 0.25) for a layout of (x, y)

    /// Draws a loop with the inside on its left. Returns its first node.
    int loop(const Points& points, int piece = 0);
    /// Draws a loop through nodes that are there.
    void loopThrough(const std::vector<int>& nodes, int piece = 0);
    int node(const Vec2& layout);

    /// Axis-parallel and counter-clockwise, from (low, low) to (high, high).
    static Points square(double low, double high);
    /// The same the other way round.
    static Points turned(Points points);
};

}  // namespace kerf::test
