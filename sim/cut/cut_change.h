#pragma once

#include <vector>

#include "sim/cut/cutter.h"

namespace kerf {

/// All triangles that a step added, removed or gave another corner: ascending, each once.
std::vector<int> changedTriangles(const CutDelta& delta);

}  // namespace kerf
