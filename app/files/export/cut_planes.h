#pragma once

#include <map>

#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The planes in which the faces of cuts are laid flat, one for each stroke: that which its walls
/// face most, at rest.
class CutPlanes {
  public:
    explicit CutPlanes(const SurfaceMesh& mesh);
    /// Where the rest place of vertex v lies in the plane of the wall triangle t [m]: across, then
    /// upwards.
    Eigen::Vector2f at(const SurfaceMesh& mesh, int t, int v) const;

  private:
    using Axes = Eigen::Matrix<double, 2, 3>;
    std::map<int, Axes> axes_;  // by stroke
};

}  // namespace kerf::app
