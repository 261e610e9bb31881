#pragma once

#include <vector>

#include "sim/cut/plan/outline.h"

namespace kerf::cut {

/// A connected part of the wall, inside one piece of the body. The triangles hold node ids and run
/// counter-clockwise in the layout plane; both walls use them, so their shape never touches the
/// volume.
struct WallSheet {
    std::vector<Triangle> triangles;  ///< triples of nodes of CutCurves
    int piece = -1;                   ///< piece of the body
};

/// Triangulates the inside of the outline. Each outer loop with its holes is one sheet: sheets of
/// different solids never see each other. Adds interior nodes to `curves` where a sheet is taller
/// than one edge. Throws StepFailure.
std::vector<WallSheet> triangulateWall(const StepInput& in, const Strip& strip,
                                       const Outline& outline, CutCurves& curves);

}  // namespace kerf::cut
