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
#include "sim/cut/stroke/resume.h"
#include "sim/cut/stroke/rung_parts.h"
#include "sim/cut/stroke/sweep.h"
#include "sim/cut/surface/broad_phase.h"
#include "sim/cut/surface/edge_length_field.h"
#include "sim/cut/surface/stroke_surface.h"
#include "sim/mesh/piece_labels.h"
#include "sim/mesh/triangle_tree.h"

namespace kerf {

// What `finish` sweeps although it is below the gate (share of the edge length around), and how
// many times the blade's offset it is at least.
inline constexpr double kLeastFlush = 0.01;
inline constexpr double kLeastFlushOffsets = 4;
// Below this share of h the blade stands still.
inline constexpr double kStandingStill = 1e-9;
// Largest distance (share of the edge length about the rung) from the sweep at which a triangle can
// matter: predicates see vertices elsewhere, and the rung is led around skin that moved across it.
inline constexpr double kBroadPhaseMargin = 3;
// Pieces whose copies lie farther apart (share of h) are swept apart.
inline constexpr double kParted = 1e-3;

/// What keeps the blade waiting.
enum class Gate {
    shareOfEdge,  ///< it has moved less than CutSettings::gate
    flush,        ///< there is hardly anything to sweep
};

/// Of walls in the step in hand (keepsMirrors). No step is refused for their sake alone.
enum class Mirrors {
    wanted,
    missed,  ///< some try failed for them
    waived,
};

/// All that a cutter remembers. Its functions stand by idea in cutter.cpp (a stroke as a whole),
/// sweep_step.cpp, sweep_groups.cpp and stroke_end.cpp.
struct Cutter::State {
    SurfaceMesh& mesh;
    CutSettings settings;
    std::shared_ptr<const cut::EdgeLengthField> edgeLengths;
    double h = edgeLengths->mean();
    int stroke = 0;
    int pass = 0;  ///< the last one of any sweep
    bool inStroke = false;
    Blade blade{};  ///< the last one given
    std::vector<cut::Sweep> sweeps{};
    std::vector<RungNode> rung{};  ///< those of all sweeps, one after the other
    bool madeWalls = false;        ///< in this stroke
    PieceLabels pieces{mesh, PieceLabels::Measures::none};  ///< measured once a stroke begins
    TriangleFinder* finder = nullptr;                       ///< null: the tree
    std::optional<TriangleTree> tree{};                     ///< made when it is first asked
    std::optional<double> moved{};  ///< how far vertices moved at most since the last step [m]
    bool atRest = false;            ///< all of the body is known to lie still where it rests
    std::vector<int> groupOfPiece{};
    bool groupsHold = false;  ///< since they were made nothing has moved or been cut
    int firstTriangle = 0;    ///< slot from which on the stroke made triangles
    Mirrors mirrors = Mirrors::wanted;
    std::set<int> piecesToCross{};  ///< in which the step in hand must cross the stroke's walls
    double restVolume = 0;          ///< of the body at the start of the stroke [m^3]
    cut::StrokeSurface surface{mesh};
    std::optional<cut::Cleanup> cleanup{};  ///< of this stroke, once it has cut

    Blade nearBody(const Blade& whole);
    void start(const Blade& at);
    CutResult sweepAll(const Blade& to, Gate gate);
    double gateLength(Gate gate, double edge) const;
    double edgeLengthAbout(const std::vector<RungNode>& nodes) const;
    bool liesAtRest(int v) const;
    void noteMotion();
    TriangleFinder& findTriangles();
    double margin(double edge) const;
    void follow(const std::vector<int>& changed, int groupOfNewPieces);
    void followCleanUp(const std::vector<int>& changedBefore, const CutDelta& delta);
    void divideSweeps();
    std::vector<int> lowestVertices(std::set<int> groups) const;
    int groupOfVertex(int v) const;
    void joinRungs();
    void cleanUpBehindFront(CutResult& result);
    void mend(const std::vector<int>& triangles, CutDelta& delta);
    void cleanUpAtEnd(CutResult& result);
    void closeWounds(CutResult& result);
    void patch(const cut::Wound& wound, CutResult& result);
    void removeDebris(CutResult& result);
    void holdLivingVertices();
    void tieRungs();

    // Of one group.
    void startPass(cut::Sweep& sweep);
    void placeRung(const Blade& at, cut::Sweep& sweep);
    void slideRung(const Blade& to, const std::vector<RungNode>& from, cut::Sweep& sweep);
    void setRung(std::vector<RungNode> next, cut::Sweep& sweep);
    void tie(cut::Sweep& sweep);
    void makeWaitingTies(cut::Sweep& sweep);
    CutResult advance(const Blade& to, Gate gate, cut::Sweep& sweep);
    static bool goesInParts(const Blade& to, const std::vector<RungNode>& from,
                            const cut::Sweep& sweep);
    CutResult cutParts(const Blade& to, const std::vector<cut::RungPart>& parts, cut::Sweep& sweep);
    CutResult cut(const Blade& to, const std::vector<RungNode>& from, cut::Sweep& sweep);
    bool findStep(const std::function<bool()>& find);
    bool climb(const Blade& to, const cut::RungPart& part, cut::Sweep& sweep, CutResult& result);
    bool climbOpened(const Blade& to, const cut::RungPart& part, const cut::BroadPhase& candidates,
                     cut::Sweep& sweep, CutResult& result);
    bool tryLevels(const Blade& to, const cut::RungPart& part, const cut::BroadPhase& candidates,
                   const cut::SlitOpening& opening, int levels, cut::Sweep& sweep,
                   CutResult& result);
    bool mayWait(const cut::Sweep& sweep) const;
    bool resume(const Blade& to, const std::vector<RungNode>& from, cut::Sweep& sweep,
                CutResult& result);
    bool startAnew(const cut::Resumption& way, cut::Sweep& sweep, CutResult& result);
    void sweepOn(const Blade& to, cut::Sweep& sweep, CutResult& result);
    bool attempt(const Blade& to, const cut::RungPart& part, const cut::BroadPhase& candidates,
                 const cut::SlitOpening& opening, int level, cut::Sweep& sweep, CutResult& result);
    void requireVolume(const cut::StepPlan& plan) const;
    void requireCrossing(const cut::PlannedStep& step) const;
    void requireMirrors(const cut::StepPlan& plan, double edge);
    CutResult accept(const Blade& to, const cut::PlannedStep& step, const cut::RungPart& part,
                     cut::Sweep& sweep);
    void keepOwnNodes(std::vector<RungNode> nodes, cut::Sweep& sweep);
    static void moveOn(const Blade& to, const CutResult& result, cut::Sweep& sweep);
    void countRefusal(const Blade& to, cut::Sweep& sweep);
    cut::BroadPhase findCandidates(const Blade& to, const cut::Sweep& sweep,
                                   const std::vector<RungNode>& from);
    /// Tells the triangles of the group that were there before the stroke, or divide such.
    std::function<bool(int)> isOuter(const cut::Sweep& sweep) const;
};

}  // namespace kerf
