#pragma once

#include <vector>

#include "sim/cut/glue.h"

namespace kerf::cut {

/// A complete step, ready to be carried out.
struct StepPlan {
    CutCurves curves;
    Outline outline;
    Subdivision subdivision;
    std::vector<NewTriangle> triangles;  ///< surface first, then W+, then W-
    std::vector<GluePartner> partners;   ///< by 3 * triangle + edge
    RungNode endA;                       ///< the ends of the new rung, in the air
    RungNode endB;
    bool retraces = false;        ///< the blade runs along an older slit
    double volumeChange = 0;      ///< signed, before rounding [m^3]
    double restVolumeChange = 0;  ///< the same of the rest shape
};

/// What a step made of the mesh.
struct CommitResult {
    CutDelta delta;
    std::vector<RungNode> rung;  ///< the new one, from A to B
    int splitVertices = 0;       ///< copies of vertices that were made
    std::vector<int> onSeams;    ///< new vertices on walls that were divided but not cut
};

/// Changes the mesh. Cannot fail. The front edges of `staying` are not the step's, and stay. Every
/// umbrella of the new surface becomes one vertex; the first one keeps the old number, others
/// become mates of it.
CommitResult commit(SurfaceMesh& mesh, const StepPlan& plan, double h, int stroke,
                    const std::vector<RungNode>& staying);

}  // namespace kerf::cut
