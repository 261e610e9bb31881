#pragma once

#include "sim/cut/cut_types.h"
#include "sim/cut/patch/patch_plan.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Puts a patch on both sides in place of the walls of a wound. Cannot fail. New vertices are at
/// the means of others, on each side by itself: the two may lie apart. Adds the change to `delta`,
/// of which firstNewVertex must be set; returns the triangle slots that were removed or added,
/// ascending.
std::vector<int> commitPatch(SurfaceMesh& mesh, const Wound& wound, const PatchPlan& plan,
                             CutDelta& delta);

}  // namespace kerf::cut
