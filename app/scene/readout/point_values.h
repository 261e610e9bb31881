#pragma once

#include "app/scene/readout/surface_anchor.h"

namespace kerf::app {

/// What is plotted of a point of the surface.
struct PointValues {
    double strain = 0;  ///< the larger principal strain, as in render::SurfaceField
    double area = 0;    ///< change of area, as there
    double way = 0;     ///< from its place at rest [m]
    double speed = 0;   ///< [m/s]
};

/// The values at a point now; reads the triangles around it back if stale.
PointValues valuesAt(const SurfaceMesh& mesh, const SurfaceAnchor& anchor);

}  // namespace kerf::app
