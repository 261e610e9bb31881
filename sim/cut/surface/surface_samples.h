#pragma once

#include <functional>
#include <vector>

#include "sim/mesh/box_tree.h"

namespace kerf::cut {

/// A vertex that represents a part of the surface.
struct SurfaceSample {
    int vertex = -1;    ///< vertex of the mesh
    double weight = 0;  ///< how many triangles it represents
};

/// Calls visit(sample) for those of the samples whose vertices belong to `piece`, in their order.
template <class Visit>
void forEachOfPiece(const std::vector<SurfaceSample>& samples,
                    const std::vector<int>& pieceOfVertex, int piece, Visit visit) {
    for (const SurfaceSample& sample : samples) {
        if (pieceOfVertex[sample.vertex] == piece) {
            visit(sample);
        }
    }
}

/// Boxes around a few clusters of `places` (at least one), with room for a blade that advances by
/// some `h`.
std::vector<Bounds> boxesAround(std::vector<Vec3> places, double h);

/// The vertices around `boxes` (rest space), each once: all near them, fewer with distance relative
/// to `h`, so that their number grows with the logarithm of the body. `tree` holds triangles by
/// their box at rest, `cornersOf(id)` gives their corners. `slots`: -1 for each vertex, before and
/// after. (Thinned by distance as in Barnes and Hut 1986.)
std::vector<SurfaceSample> thinByDistance(BoxTree& tree,
                                          const std::function<const Triangle&(int id)>& cornersOf,
                                          const std::vector<Bounds>& boxes, double h,
                                          std::vector<int>& slots);

}  // namespace kerf::cut
