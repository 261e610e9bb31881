#pragma once

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/plan/input/slit_opening.h"
#include "sim/cut/surface/air_ties.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// What a stroke has made of its walls so long ago that they count as those of an older one: a
/// blade that comes round to where it started runs in their gap. Walls that the front has only just
/// made it may not meet.
class OwnPast {
  public:
    /// The front starts from the air; vertices from `firstVertex` on will be made.
    void start(int firstVertex);
    /// The front has come back into its own slit: all walls so far, up to `endVertex`, are past.
    void closeUp(int endVertex);
    /// The first walls have been made. They end, where the blade was put down, at these vertices.
    void begin(std::vector<int> startVertices) { start_ = std::move(startVertices); }
    /// The front goes on by `way`, as a share of the edge length. Vertices from `nextVertex` on are
    /// made then.
    void goOn(double way, int nextVertex);
    /// The vertices of walls that are past.
    const VertexRange& vertices() const { return past_; }
    /// The vertices where the first of these walls end, some of which may be dead. Empty before
    /// there are such walls.
    std::span<const int> startVertices() const {
        return past_.first < past_.end ? std::span<const int>(start_) : std::span<const int>();
    }

  private:
    /// The front before a step.
    struct Mark {
        double way;
        int nextVertex;
    };
    VertexRange past_;
    std::vector<int> start_;
    double way_ = 0;
    std::vector<Mark> recent_;  ///< of steps that are not past
};

/// The stroke as one group of pieces sees it (groupPieces). Each group waits and refuses for
/// itself. Its transits are the ways of the blade through it, each from air to air.
struct GroupStroke {
    int vertex = -1;               ///< some vertex of the group
    int number = -1;               ///< the group's number (groupPieces)
    int transit = 0;               ///< goes up each time the blade starts from the air
    int firstVertexOfTransit = 0;  ///< vertices from here on were made in the transit
    OwnPast past;                  ///< what it has made of its walls so long ago that they are old
    std::set<int> onSeams;         ///< vertices of the transit on walls of older ones
    bool opensSlits = true;        ///< whether older slits along the way are seen open
    std::map<int, Vec3> sides;     ///< ways in which older slits open (OpeningInput::sides)
    std::map<int, Vec3> flushSides;  ///< StepInput::flushSides
    bool leftPlane = false;          ///< the blade runs beside its plane, where a step first had to
    int refusedInARow = 0;           ///< steps refused since the last one that was not
    std::vector<RungNode> rung;      ///< the group's rung, from A to B
    double edgeLength = 0;           ///< edge length about the rung [m]
    AirTies airTies;                 ///< hold the rung in the air to the skin
    bool tiesWait = false;  ///< they are made once they are needed: nothing has moved from rest
    Blade blade;            ///< the blade when the rung was made
    Vec3 lastAdvance = Vec3::Zero();  ///< way of the blade's middle in the last step that cut [m]
    /// The direction in which the front went on in the last step that cut; zero while the rung is
    /// in the air.
    Vec3 heading = Vec3::Zero();
    bool isUneven = false;  ///< part of the rung stayed when the rest last went on
};

/// The way of the blade since the old rung.
struct BladeMotion {
    double advance = 0;        ///< largest distance of a rung node to the line of the blade [m]
    double axial = 0;          ///< largest distance of the rung's ends to the blade's ends [m]
    bool anyAttached = false;  ///< the rung has a front edge
};

/// Takes the positions of rung vertices from the mesh, which may have moved.
void followMesh(const SurfaceMesh& mesh, std::vector<RungNode>& rung);

/// Sets the rung's s to where its nodes lie along the new blade, so that sliding along its axis
/// (sawing, plunging) does not shear the strip. s is forced to increase. The blade must have a
/// length.
BladeMotion reparametrize(const Blade& blade, double h, std::vector<RungNode>& rung);

/// Whether more than half of the front would move back into its own slit. Walls that the solver has
/// bent may point anywhere: what goes on in the direction `lastAdvance` of the last cut counts as
/// forwards (zero where there was none). `h`: edge length of walls [m].
bool isWithdrawing(const SurfaceMesh& mesh, const Blade& blade, double h, const Vec3& lastAdvance,
                   const std::vector<RungNode>& rung);

}  // namespace kerf::cut
