#pragma once

#include "sim/cut/plan/curves/outline.h"

namespace kerf::cut {

/// A closed chain of outline edges.
using Loop = std::vector<OutlineEdge>;

/// A connected part of the wall by its border in the layout plane.
struct Sheet2d {
    Loop outer;               ///< counter-clockwise
    std::vector<Loop> holes;  ///< clockwise
};

/// Chains the outline into nested loops: counter-clockwise ones are outer loops, others are holes
/// of the smallest outer loop around them. Throws StepFailure.
std::vector<Sheet2d> nestLoops(const StepInput& in, const Outline& outline,
                               const std::vector<CutNode>& nodes);

}  // namespace kerf::cut
