#pragma once

#include "sim/cut/cut_types.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// A vertex that follows the material for a step instead of forces.
struct Anchor {
    int vertex = -1;
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// The body and the step, from which anchors are found.
struct AnchorFrame {
    const SurfaceMesh& mesh;
    const std::vector<int>& pieceOfVertex;  ///< of all vertices of the mesh
    double edgeLength = 0;                  ///< about the front, as the cutter maps walls [m]
    const cut::StrokeSurface& surface;
    double timeStep = 0;      ///< [s]
    double catchUpSpeed = 0;  ///< of a vertex relative to the material, at most [m/s]
};

/// The front of an unfinished slit is in uncut material, which a surface mesh does not model: with
/// its two walls only it would slide and eject each new row. So every inner vertex of the front is
/// moved to its rest position under the affine map rest -> current, fitted around it to the surface
/// that its piece had before the stroke, and kept below that surface.
std::vector<Anchor> findFrontAnchors(const std::vector<RungNode>& rung, const AnchorFrame& in);

/// Anchors for all hidden vertices (SurfaceMesh::hidden), the front's among them: they have
/// neither mass nor constraints.
std::vector<Anchor> findHiddenAnchors(const std::vector<int>& hidden, const AnchorFrame& in);

}  // namespace kerf
