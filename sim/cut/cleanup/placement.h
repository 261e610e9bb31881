#pragma once

#include "sim/cut/cleanup/one_ring.h"
#include "sim/cut/cleanup/workspace.h"
#include "sim/mesh/deformation_field.h"

namespace kerf::cut {

/// Moves the planned places of all rings' vertices so that each piece keeps its volume: the
/// shortest displacement d with g_k . d = r_k for every ring k, g_k being the gradient of its
/// volume and r_k what the operation would change (Lindstrom and Turk, Fast and Memory Efficient
/// Polygonal Simplification, 1998, here for all copies of a point together). Copies at one place
/// share d; copies of an open slit are solved one by one. The current shape follows the rest shape
/// as far as its volumes allow. Returns the remaining change.
VolumeDefect placeByVolume(const Workspace& workspace, std::vector<OneRing>& rings);

/// The change of volume if the vertex of every ring moves exactly as planned.
VolumeDefect volumeDefect(const SurfaceMesh& mesh, const std::vector<OneRing>& rings);

/// The gradient of the volume by the position of a vertex, in the shape `places` [m^2].
Vec3 volumeGradient(const SurfaceMesh& mesh, const VertexPositions& places, int vertex);

/// Whether all of these vertices coincide with the first one, to the precision of `h` [m].
bool haveOnePlace(const VertexPositions& places, const std::vector<int>& vertices, double h);

/// The part of `direction` along which no gradient changes.
Vec3 projectOnConstantVolume(const std::vector<Vec3>& gradients, const Vec3& direction);

/// The rest length over the current length of the edges around a vertex.
double restStretch(const SurfaceMesh& mesh, int vertex);

}  // namespace kerf::cut
