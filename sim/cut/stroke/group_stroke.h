#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cut_types.h"
#include "sim/cut/plan/input/slit_opening.h"
#include "sim/cut/surface/air_ties.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::cut {

/// The walls of a stroke that are far enough behind its front to count as those of an older one: a
/// blade that comes round to its start runs in their gap. It may not meet walls that the front has
/// just made.
class OwnPast {
  public:
    /// The front starts from the air; new vertices are numbered from `firstVertex` on.
    void start(int firstVertex);
    /// The front has re-entered its own slit: all walls so far, up to `endVertex`, are past.
    void closeUp(int endVertex);
    /// Records the first walls, which end at these vertices, where the blade was put down.
    void begin(std::vector<int> startVertices) { start_ = std::move(startVertices); }
    /// The front advances by `way`, as a share of the edge length, making vertices from
    /// `nextVertex` on.
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

/// The stroke within one group of pieces (groupPieces). Each group waits and refuses separately.
/// Its transits are the passes of the blade through it, each from air to air.
struct GroupStroke {
    int vertex = -1;                 ///< some vertex of the group
    int number = -1;                 ///< the group's number (groupPieces)
    int transit = 0;                 ///< goes up each time the blade starts from the air
    int firstVertexOfTransit = 0;    ///< vertices from here on were made in the transit
    OwnPast past;                    ///< its own walls that count as old
    std::set<int> onSeams;           ///< vertices of the transit on walls of older ones
    bool opensSlits = true;          ///< whether older slits along the path are seen open
    std::map<int, Vec3> sides;       ///< directions in which older slits open (OpeningInput::sides)
    std::map<int, Vec3> flushSides;  ///< StepInput::flushSides
    bool leftPlane = false;          ///< the blade runs beside its plane, since a step had to
    int refusedInARow = 0;           ///< steps refused since the last one that was not
    std::vector<RungNode> rung;      ///< the group's rung, from A to B
    double edgeLength = 0;           ///< edge length about the rung [m]
    AirTies airTies;                 ///< hold the rung in the air to the skin
    bool tiesWait = false;           ///< made on demand: nothing has moved from rest
    Blade blade;                     ///< the blade when the rung was made
    Vec3 lastAdvance = Vec3::Zero();  ///< motion of the blade's middle in the last cut [m]
    /// The direction of the front's advance in the last step that cut; zero while the rung is in
    /// the air.
    Vec3 heading = Vec3::Zero();
    bool isUneven = false;  ///< part of the rung stayed in the last advance
};

/// The motion of the blade since the old rung.
struct BladeAdvance {
    double advance = 0;        ///< largest distance of a rung node to the line of the blade [m]
    double axial = 0;          ///< largest distance of the rung's ends to the blade's ends [m]
    bool anyAttached = false;  ///< the rung has a front edge
};

/// Updates the positions of rung vertices from the mesh.
void followMesh(const SurfaceMesh& mesh, std::vector<RungNode>& rung);

/// How many times as far as CutSettings::gate says the front may lag: where walls are graded, a
/// front that is mostly far from the rim has longer edges, and so higher rows.
double rowGrowth(const CutSettings& settings, const GroupStroke& group);

/// Sets the rung's s to the positions of its nodes along the new blade, so that sliding along its
/// axis (sawing, plunging) does not shear the strip. s is forced to increase. The blade must have a
/// length.
BladeAdvance reparametrize(const Blade& blade, double h, std::vector<RungNode>& rung);

/// Whether more than half of the front would move back into its own slit. Walls bent by the solver
/// may point anywhere, so the direction `lastAdvance` of the last cut counts as forwards (zero for
/// none). `h`: edge length of walls [m].
bool isWithdrawing(const SurfaceMesh& mesh, const Blade& blade, double h, const Vec3& lastAdvance,
                   const std::vector<RungNode>& rung);

/// A strip that replaces a refused one: it starts in the material behind the front, on one side of
/// the walls there, and ends on the other, so that the new walls cross the old ones. It does not
/// share the old front, which stays as the end of a slit.
struct Resumption {
    std::vector<RungNode> rung;  ///< the start, without vertices
    Blade blade;                 ///< the end, offset sideways by a share of h
};

/// Restarts behind `rung`, which cross the old walls close to their end and end a little ahead of
/// it, towards `blade`. Where the walls are crumpled they may miss them (leavesBridge). `h`: edge
/// length of walls [m]. Empty if the blade hardly moves.
std::vector<Resumption> resumptions(const std::vector<RungNode>& rung, const Blade& blade,
                                    double h);

}  // namespace kerf::cut
