#pragma once

#include <vector>

#include "sim/cut/plan/outline.h"

namespace kerf::cut {

/// A closed chain of outline edges.
using Loop = std::vector<OutlineEdge>;

/// An outer loop and the holes in it.
struct Sheet2d {
    Loop outer;
    std::vector<Loop> holes;
};

/// Chains the outline into loops and nests them: counter-clockwise loops are outer ones, others
/// are holes of the smallest outer loop around them. Throws StepFailure.
std::vector<Sheet2d> nestLoops(const StepInput& in, const Outline& outline,
                               const std::vector<Node>& nodes);

}  // namespace kerf::cut
