#pragma once

#include <vector>

#include "sim/body/body_model.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Triangles from slot `first` on around the ends of folded edges: those that are bent by more than
/// a right angle from rest, of which a triangle has such a slot. Ends of slits do not count, nor do
/// walls of an open stroke. Ascending. Fetches the positions of these triangles alone.
std::vector<int> foldedTriangles(const SurfaceMesh& mesh, int first);

/// How much of each piece is turned inside out where `mesh`, that of the model, lies now: of the
/// columns of material that ISPCs stand for the share, by volume at rest, of those that leave
/// through the skin of their vertex instead of into the body. 0 to 1, shape [pieces]. At rest it is
/// 0, and however much a body bends or stretches it stays near that. O(n).
std::vector<double> sharesInsideOut(const BodyModel& model, const SurfaceMesh& mesh);

}  // namespace kerf
