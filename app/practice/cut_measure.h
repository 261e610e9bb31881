#pragma once

#include "app/practice/task.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// A body that was cut between two strokes, for measureCut().
struct TaskBody {
    const Task& task;
    const SurfaceMesh& mesh;
    const SurfaceMesh& uncut;
    std::span<const int> members;       ///< the model of each triangle slot of the mesh
    std::span<const int> uncutMembers;  ///< of the uncut mesh
};

/// What was cut, measured at rest. A figure is none where there is nothing to measure.
struct CutScore {
    std::optional<double> deviationMean;  ///< of the rim from the line [m]
    std::optional<double> deviationMax;   ///< [m]
    std::optional<double> depthMean;      ///< [m]
    std::optional<double> depthInBand;    ///< share of the cut
    std::optional<double> lengthUnder;    ///< of the lines, uncut [m]
    std::optional<double> lengthOver;     ///< of rims above that belong to no line [m]
    std::optional<double> marginLeast;    ///< between cuts and what is spared [m]
    std::optional<double> sparedCut;  ///< models and regions to spare that were cut, models torn
    std::optional<double> taken;      ///< 1 for a model that is whole in a piece apart, else 0
    std::optional<double> excisedVolume;  ///< of that piece [m^3]
};

/// Measures a cut. Reads only the rest shape. Walls of tears are left out, but in `sparedCut`.
CutScore measureCut(const TaskBody& body);

/// An edge between a wall of a blade and the skin.
struct RimDeviation {
    int halfEdge;                     ///< of the wall
    std::optional<double> deviation;  ///< of its middle from the lines [m]; none beyond them
};
/// All of the body to cut.
std::vector<RimDeviation> rimDeviations(const TaskBody& body);

}  // namespace kerf::app
