#pragma once

#include "sim/cut/cleanup/workspace.h"
#include "sim/cut/cut_types.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// Removes the slivers that a stroke leaves: collapses, flips and slides that treat all copies of
/// a vertex alike, so that walls stay mirrored. Each keeps the volume of every piece,
/// current and at rest, to kVolumePerOperation of the body, and moves skin and rims by no more
/// than kMostDeviation of an edge, summed up over the stroke.
class Cleanup {
  public:
    /// Prepares for one stroke on `mesh`; both arguments must outlive the object.
    Cleanup(SurfaceMesh& mesh, const EdgeLengthField& edgeLengths);

    /// Cleans up what the last two steps made, except beside the rung. `delta` is that of the step;
    /// the changes are added to it.
    CleanupStatistics behindFront(const std::vector<RungNode>& rung, CutDelta& delta);
    /// Appends the vertices that the next behindFront() is likely to read.
    void addVertices(std::vector<int>& vertices) const;
    /// Cleans up all that the stroke made, including the end of the slit.
    CleanupStatistics atEnd(CutDelta& delta);
    /// Removes short edges at some triangles, without a stroke. Judges by the rest shape, however
    /// crumpled the body is.
    CleanupStatistics mend(const std::vector<int>& triangles, CutDelta& delta);

    /// An upper bound of how far any vertex was moved at rest since the last call [m].
    double takeRestMotion() { return workspace_.takeRestMotion(); }

  private:
    std::vector<int> trianglesOfStroke() const;
    CleanupStatistics clean(const std::vector<int>& triangles, CutDelta& delta);

    Workspace workspace_;
    int firstTriangle_;          ///< the first slot of the stroke
    std::vector<int> lastStep_;  ///< triangles of the previous step
};

}  // namespace kerf::cut
