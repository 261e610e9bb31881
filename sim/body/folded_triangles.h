#pragma once

#include <vector>

#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Triangles from slot `first` on around the ends of folded edges: those that are bent by more than
/// a right angle from rest, of which a triangle has such a slot. Ends of slits do not count, nor do
/// walls of an open stroke. Ascending. Fetches the positions of these triangles alone.
std::vector<int> foldedTriangles(const SurfaceMesh& mesh, int first);

}  // namespace kerf
