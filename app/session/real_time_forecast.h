#pragma once

#include "sim/base/params.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// How fast a body that has landed will move on this machine, whole and without drawing.
struct RealTimeForecast {
    double factor = 0;      ///< see realTimeFactor()
    double timeStep = 0;    ///< [s]
    int iterations = 0;     ///< of a step
    int implicitSteps = 1;  ///< that a time step is made of; 1 with other solvers
};

/// Runs a few steps of `mesh`, placed in the world, on the OpenGL context that is current. For one
/// of more than 12,000 triangles a ball of its size stands in, whose times are scaled. Takes part
/// of a second. Throws like Simulation.
RealTimeForecast realTimeForecast(const SurfaceMesh& mesh, const Params& params);

}  // namespace kerf::app
