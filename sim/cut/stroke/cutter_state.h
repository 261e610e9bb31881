#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "sim/cut/cleanup/cleanup.h"
#include "sim/cut/patch/wound.h"
#include "sim/cut/plan/plan.h"
#include "sim/cut/plan/slit_opening.h"
#include "sim/cut/stroke/cutter.h"
#include "sim/cut/stroke/group_stroke.h"
#include "sim/cut/stroke/resume.h"
#include "sim/cut/stroke/rung_parts.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf {

/// The way that `finish` cuts although it is below the gate, as a share of the edge length around.
inline constexpr double kLeastFlush = 0.01;
/// How many times the blade's offset that way is at least.
inline constexpr double kLeastFlushOffsets = 4;
/// The way below which the blade stands still, as a share of h.
inline constexpr double kStandingStill = 1e-9;
/// The largest distance from the strip at which a triangle can matter, as a share of the edge
/// length about the rung: predicates see vertices elsewhere, and the rung is led around skin that
/// moved across it.
inline constexpr double kBroadPhaseMargin = 3;
/// The distance between copies, as a share of h, from which on their pieces are cut apart.
inline constexpr double kParted = 1e-3;

/// The reason for which the blade waits.
enum class Gate {
    shareOfEdge,  ///< it has moved less than CutSettings::gate
    flush,        ///< it has hardly moved (kLeastFlush)
};

/// Whether older walls must stay mirrored in the step in hand (keepsMirrors). No step is refused
/// for their sake alone.
enum class Mirrors {
    wanted,  ///< a try fails where they do not
    missed,  ///< some try has failed for them alone
    waived,  ///< tries do not look at them
};

/// All that a cutter remembers. Its functions stand by idea in cutter.cpp (a stroke as a whole),
/// group_step.cpp, stroke_groups.cpp and stroke_end.cpp.
struct Cutter::State {
    SurfaceMesh& mesh;                                        ///< the body
    CutSettings settings;                                     ///< how finely it is cut
    std::shared_ptr<const cut::EdgeLengthField> edgeLengths;  ///< edge lengths by rest position
    double h = edgeLengths->mean();                           ///< the mean edge length [m]
    int stroke = 0;                          ///< number of the stroke, as in wall labels
    int transit = 0;                         ///< number of the last transit of any group
    bool inStroke = false;                   ///< between begin() and finish()
    Blade blade{};                           ///< the last one given
    std::vector<cut::GroupStroke> groups{};  ///< the stroke by group of pieces
    std::vector<RungNode> rung{};            ///< rungs of all groups in turn
    bool madeWalls = false;                  ///< some step of the stroke has cut
    PieceLabels pieces{mesh, PieceLabels::Measures::none};  ///< measured once a stroke begins
    TriangleFinder* finder = nullptr;                       ///< null: the tree
    std::optional<TriangleTree> tree{};                     ///< made when it is first asked
    std::optional<double> moved{};      ///< how far vertices moved at most since the last step [m]
    bool atRest = false;                ///< all of the body is known to lie still where it rests
    std::vector<int> groupOfPiece{};    ///< number of the group of each piece
    bool groupsHold = false;            ///< since they were made nothing has moved or been cut
    int firstTriangle = 0;              ///< slot from which on the stroke made triangles
    Mirrors mirrors = Mirrors::wanted;  ///< for the step in hand
    SearchWork searchWork{};            ///< since it was last taken
    std::set<int> piecesToCross{};      ///< pieces in which the step must cross the stroke's walls
    double restVolume = 0;              ///< rest volume of the body before the stroke [m^3]
    cut::StrokeSurface surface{mesh};   ///< the surface before the stroke
    std::optional<cut::Cleanup> cleanup{};  ///< the stroke's clean-up, once it has cut

    /// The part of a blade that may reach the body.
    Blade nearBody(const Blade& whole);
    /// Begins a stroke.
    void start(const Blade& at);
    /// Lets every group take a step to the blade.
    CutResult advanceAll(const Blade& to, Gate gate);
    /// The way below which a group waits, for an edge length about its rung [m].
    double gateLength(Gate gate, double edge) const;
    /// The edge length about the nodes of a rung [m].
    double edgeLengthAbout(const std::vector<RungNode>& nodes) const;
    /// Whether a vertex lies still where it rests.
    bool liesAtRest(int v) const;
    /// Takes note of what the solver moved since the last call.
    void noteMotion();
    /// The finder given, or the cutter's own tree.
    TriangleFinder& findTriangles();
    /// The distance from the strip within which a step looks, for an edge length there [m].
    double margin(double edge) const;
    /// Follows a change of the mesh with everything that is looked up in it.
    void follow(const std::vector<int>& changed, int groupOfNewPieces);
    /// Follows what the clean-up changed beyond `changedBefore`.
    void followCleanUp(const std::vector<int>& changedBefore, const CutDelta& delta);
    /// Gives groups of their own to pieces that have parted.
    void divideGroups();
    /// The lowest vertex of each of these groups, ascending.
    std::vector<int> lowestVertices(std::set<int> numbers) const;
    /// The number of the group of a vertex, -1 for none.
    int groupOfVertex(int v) const;
    /// Makes `rung` of the rungs of all groups.
    void joinRungs();
    /// Removes slivers behind the front after a step.
    void cleanUpBehindFront(CutResult& result);
    /// Removes short edges at some triangles between strokes.
    void mend(const std::vector<int>& triangles, CutDelta& delta);
    /// Removes slivers everywhere and coarsens walls when the stroke ends.
    void cleanUpAtEnd(CutResult& result);
    /// Ends the open course: patches its wounds.
    void closeWounds(CutResult& result);
    /// Patches one wound, or counts why not.
    void patch(const cut::Wound& wound, CutResult& result);
    /// Removes small pieces when the stroke ends.
    void removeDebris(CutResult& result);
    /// Lets every group name a vertex that is in use.
    void holdLivingVertices();
    /// Ties the rungs of all groups to the skin.
    void tieRungs();

    // Functions of one group.
    /// Begins a transit: the blade starts from the air.
    void startTransit(cut::GroupStroke& group);
    /// Places the rung at a blade, with its offset, as a new transit.
    void placeRung(const Blade& at, cut::GroupStroke& group);
    /// Takes a rung in the air along with a blade that slides along itself.
    void slideRung(const Blade& to, const std::vector<RungNode>& from, cut::GroupStroke& group);
    /// Sets the rung and ties it.
    void setRung(std::vector<RungNode> next, cut::GroupStroke& group);
    /// Ties the rung to the skin, or notes that this can wait.
    void tie(cut::GroupStroke& group);
    /// Makes the ties that wait, in the rest shape.
    void makeWaitingTies(cut::GroupStroke& group);
    /// Takes the step to the blade, in parts where the blade is behind the rung somewhere.
    CutResult advance(const Blade& to, Gate gate, cut::GroupStroke& group);
    /// Whether parts of the rung go on by themselves.
    static bool goesInParts(const Blade& to, const std::vector<RungNode>& from,
                            const cut::GroupStroke& group);
    /// Takes a step for each part of the rung.
    CutResult cutParts(const Blade& to, const std::vector<cut::RungPart>& parts,
                       cut::GroupStroke& group);
    /// Takes a step for the whole rung, or refuses it.
    CutResult cut(const Blade& to, const std::vector<RungNode>& from, cut::GroupStroke& group);
    /// Calls `find` with mirrors wanted, and again without where they alone are in the way.
    bool findStep(const std::function<bool()>& find);
    /// Climbs the retry ladder, with older slits seen open and then as they are.
    bool climb(const Blade& to, const cut::RungPart& part, cut::GroupStroke& group,
               CutResult& result);
    /// Climbs the ladder with older slits along the blade seen open, then farther open.
    bool climbOpened(const Blade& to, const cut::RungPart& part, const cut::BroadPhase& candidates,
                     cut::GroupStroke& group, CutResult& result);
    /// Tries the first `levels` levels of the ladder.
    bool tryLevels(const Blade& to, const cut::RungPart& part, const cut::BroadPhase& candidates,
                   const cut::SlitOpening& opening, int levels, cut::GroupStroke& group,
                   CutResult& result);
    /// Whether a refused step may wait for the next one before the front is let go.
    bool mayWait(const cut::GroupStroke& group) const;
    /// Lets go of the front and cuts anew from behind it.
    bool resume(const Blade& to, const std::vector<RungNode>& from, cut::GroupStroke& group,
                CutResult& result);
    /// Tries one way to cut anew.
    bool startAnew(const cut::Resumption& way, cut::GroupStroke& group, CutResult& result);
    /// Goes on to the blade after a start close beside the old walls.
    void goOn(const Blade& to, cut::GroupStroke& group, CutResult& result);
    /// Plans and carries out a step at one level of the ladder; false where it is not valid.
    bool attempt(const Blade& to, const cut::RungPart& part, const cut::BroadPhase& candidates,
                 const cut::SlitOpening& opening, int level, cut::GroupStroke& group,
                 CutResult& result);
    /// Throws StepFailure where a step would change the body's volume.
    void requireVolume(const cut::StepPlan& plan) const;
    /// Throws StepFailure where a step leaves a bridge in `piecesToCross`.
    void requireCrossing(const cut::PlannedStep& step) const;
    /// Throws StepFailure where a step divides the two sides of an older wall differently.
    void requireMirrors(const cut::StepPlan& plan, double edge);
    /// Carries out a planned step.
    CutResult accept(const Blade& to, const cut::PlannedStep& step, const cut::RungPart& part,
                     cut::GroupStroke& group);
    /// Makes the rung of those `nodes` that are not in other groups.
    void keepOwnNodes(std::vector<RungNode> nodes, cut::GroupStroke& group);
    /// Remembers the blade of a step that was taken.
    static void moveOn(const Blade& to, const CutResult& result, cut::GroupStroke& group);
    /// Counts a refused step; after several the front is let go.
    void countRefusal(const Blade& to, cut::GroupStroke& group);
    /// The triangles of the group near the way from a rung to the blade.
    cut::BroadPhase findCandidates(const Blade& to, const cut::GroupStroke& group,
                                   const std::vector<RungNode>& from);
    /// Tells the triangles of the group that were there before the stroke, or divide such.
    std::function<bool(int)> isOuter(const cut::GroupStroke& group) const;
};

}  // namespace kerf
