#pragma once

#include "sim/cut/cut_types.h"
#include "sim/cut/patch/patch_plan.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Replaces the walls of a wound by a patch on both sides. Cannot fail. New vertices are at the
/// means of others of the same side, so the two sides may be apart. Adds the change to `delta`,
/// whose firstNewVertex must be set; returns the removed or added triangle slots, ascending.
std::vector<int> commitPatch(SurfaceMesh& mesh, const Wound& wound, const PatchPlan& plan,
                             CutDelta& delta);

}  // namespace kerf::cut
