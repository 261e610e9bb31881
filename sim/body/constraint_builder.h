#pragma once

#include <optional>

#include "sim/body/constraint_lists.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf {

/// Whether at least one of the two triangles beside the edge is part of the body's surface.
inline bool isPresentEdge(const SurfaceMesh& mesh, int h) {
    return !mesh.absent(h / 3) || !mesh.absent(mesh.twin(h) / 3);
}

/// Calls f(h) for one half-edge of each present edge: the lower one.
template <class F>
void forEachEdge(const SurfaceMesh& mesh, F&& f) {
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.alive(h / 3) && h < mesh.twin(h) && isPresentEdge(mesh, h)) {
            f(h);
        }
    }
}

/// The stretching constraint of the edge of a half-edge, in the rest shape. `thickness`: of the
/// shell [m]; `skin`: extra thickness where it is no wall [m].
EdgeConstraint edgeConstraint(const SurfaceMesh& mesh, int halfEdge, double thickness,
                              double skin = 0);

/// The bending constraint of the edge of a half-edge; none where a triangle beside it is absent or
/// a sliver (height below 5 % of its longest edge), whose normal is noise.
std::optional<BendConstraint> bendConstraint(const SurfaceMesh& mesh, int halfEdge,
                                             double thickness);

}  // namespace kerf
