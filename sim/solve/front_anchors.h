#pragma once

#include <vector>

#include "sim/body/body_model.h"
#include "sim/cut/cutter.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// A vertex that follows the material for a step instead of the forces on it.
struct Anchor {
    int vertex = -1;
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// The front of an unfinished slit lies in uncut material, of which a surface mesh knows nothing:
/// left to its two walls alone it would slide about and throw off each new row. So every inner
/// vertex of the front is carried along: to where the affine map rest -> current, fitted around it
/// to the outer skin of its piece, puts its rest position. `skinVertices`: the vertices below this
/// index are those from before the stroke. `timeStep` [s].
std::vector<Anchor> findFrontAnchors(const SurfaceMesh& mesh, const BodyModel& model,
                                     const std::vector<RungNode>& rung, int skinVertices,
                                     double timeStep);

}  // namespace kerf
