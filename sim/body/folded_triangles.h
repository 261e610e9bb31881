#pragma once

#include "sim/body/body_model.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Triangles from slot `first` on around the ends of folded edges: bent by more than a right angle
/// from rest, with a triangle of such a slot. Ends of slits and walls of an open stroke do not
/// count. Ascending. Fetches only the positions of these triangles.
std::vector<int> foldedTriangles(const SurfaceMesh& mesh, int first);

/// The share of each piece that is inside out in the current positions of `mesh`, that of the
/// model. It counts the material columns of ISPCs that leave through the skin of their own vertex,
/// by volume, unless they do so at rest. 0 to 1, shape [pieces]. Bending and stretching keep it
/// near 0. O(n).
std::vector<double> sharesInsideOut(const BodyModel& model, const SurfaceMesh& mesh);

}  // namespace kerf
