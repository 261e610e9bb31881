#pragma once

#include <vector>

#include "sim/cut/cleanup/local_patch.h"
#include "sim/cut/cleanup/vertex_places.h"
#include "sim/cut/cleanup/workspace.h"

namespace kerf::cut {

/// Moves the planned places of all patches so that each piece keeps its volume: the shortest
/// displacement d with g_k . d = r_k for every patch k, g_k being the gradient of its volume and
/// r_k what the operation would change (Lindstrom and Turk, Fast and Memory Efficient Polygonal
/// Simplification, 1998, here for all copies of a point together). Copies at one place share d;
/// copies of an open slit are solved one by one. The current shape goes as the rest shape does, as
/// far as its volumes let it, so that both stay alike. Returns what remains of the change.
VolumeDefect placeByVolume(const Workspace& workspace, std::vector<Patch>& patches);

/// The change of volume if every patch's vertex goes exactly where it is planned.
VolumeDefect volumeDefect(const SurfaceMesh& mesh, const std::vector<Patch>& patches);

/// Gradient of the volume by the position of a vertex, over `places` [m^2].
Vec3 volumeGradient(const SurfaceMesh& mesh, const VertexPlaces& places, int vertex);

/// Whether all of these vertices lie where the first one does, as near as `h` [m] lets tell.
bool haveOnePlace(const VertexPlaces& places, const std::vector<int>& vertices, double h);

/// The part of `direction` along which no gradient changes.
Vec3 projectOnConstantVolume(const std::vector<Vec3>& gradients, const Vec3& direction);

/// Rest edge length over current edge length around a vertex.
double restStretch(const SurfaceMesh& mesh, int vertex);

}  // namespace kerf::cut
