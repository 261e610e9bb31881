#pragma once

#include <vector>

#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// Collapses edges inside the walls among `triangles`, all copies alike, until they are about
/// `factor` times as long as the edges around (shorter than 4/5 of it none can be spared, longer
/// than 4/3 none becomes: Botsch and Kobbelt, A Remeshing Approach to Multiresolution Modeling,
/// 2004). Rims, ends of slits and crossings keep every bit; triangles stay well shaped, so their
/// size grows with the distance from them. Returns the number of collapses.
int coarsenWalls(Workspace& workspace, const std::vector<int>& triangles, double factor);

}  // namespace kerf::cut
