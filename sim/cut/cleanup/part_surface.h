#pragma once

#include <vector>

#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// Flips edges where triangles at one vertex pass through each other, until they do not or no flip
/// helps: the chords of a curved wall pass through the skin beside its rim where the cut grazes it.
/// Looks at `triangles` (slots, some may be dead). Returns the number of flips.
int partSurface(Workspace& workspace, const std::vector<int>& triangles);

}  // namespace kerf::cut
