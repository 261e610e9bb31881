#pragma once

#include <map>
#include <set>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/surface/air_ties.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The blade's way through one group of pieces (groupPieces). Each waits and refuses for itself.
struct Sweep {
    int vertex = -1;  ///< some vertex of the group
    int group = -1;
    int pass = 0;  ///< goes up each time the blade starts from the air
    int firstVertexOfPass = 0;
    std::set<int> onSeams;      ///< vertices of the pass on walls of older ones
    bool opensSlits = true;     ///< sees older slits along its way open
    std::map<int, Vec3> sides;  ///< in which slits of earlier strokes open (SweepStep)
    int refusedInARow = 0;
    std::vector<RungNode> rung;
    double edgeLength = 0;  ///< about the rung [m]
    AirTies airTies;
    bool tiesWait = false;  ///< they are made once they are needed: nothing has moved from rest
    Blade blade;            ///< at the rung
    Vec3 lastAdvance = Vec3::Zero();  ///< of the blade's middle in the last step that cut [m]
    /// In which the front went on in the last step that cut; zero while the rung is in the air.
    Vec3 heading = Vec3::Zero();
    bool isUneven = false;  ///< part of the rung stayed when the rest last went on
};

/// How the blade moved since the old rung.
struct SweepMotion {
    double advance = 0;  ///< largest distance of a rung node to the line of the blade [m]
    double axial = 0;    ///< largest distance of the rung's ends to the blade's ends [m]
    bool anyAttached = false;
};

/// Takes the positions of rung vertices from the mesh, which may have moved.
void followMesh(const SurfaceMesh& mesh, std::vector<RungNode>& rung);

/// Measures s along the new blade, so that sliding along its axis (sawing, plunging) does not
/// shear the strip. s is forced to increase. The blade must have a length.
SweepMotion reparametrize(const Blade& blade, double h, std::vector<RungNode>& rung);

/// More than half of the front would move back into its own slit. Walls that the solver has bent
/// may point anywhere: what goes on in the direction `lastAdvance` of the last cut counts as
/// forwards (zero where there was none).
bool isWithdrawing(const SurfaceMesh& mesh, const Blade& blade, double h, const Vec3& lastAdvance,
                   const std::vector<RungNode>& rung);

}  // namespace kerf::cut
