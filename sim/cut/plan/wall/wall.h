#pragma once

#include "sim/cut/plan/curves/outline.h"

namespace kerf::cut {

/// A connected part of the wall, inside one piece of the body. The triangles hold node ids and run
/// counter-clockwise in the layout plane; both walls use them, so their shape does not affect the
/// volume.
struct WallSheet {
    std::vector<Triangle> triangles;  ///< triples of nodes of CutCurves
    int piece = -1;                   ///< piece of the body
};

/// The wall of a step.
struct Wall {
    std::vector<CutNode> nodes;     ///< inner ones, numbered after those that there were
    std::vector<WallSheet> sheets;  ///< sheets of different solids are independent
};

/// Triangulates the inside of the outline. Each outer loop with its holes is one sheet. There are
/// inner nodes where a sheet is taller than one edge. glue() checks whether the sheets fit to their
/// border and to each other. Throws StepFailure.
Wall triangulateWall(const StepInput& in, const Strip& strip, const Outline& outline,
                     const CutCurves& curves);

}  // namespace kerf::cut
