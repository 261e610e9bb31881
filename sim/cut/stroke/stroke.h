#pragma once

#include "sim/cut/blade.h"
#include "sim/cut/cleanup/cleanup.h"
#include "sim/cut/stroke/cut_body.h"
#include "sim/cut/stroke/group_stroke.h"

namespace kerf::cut {

/// The motion below which the blade counts as still, as a share of h.
inline constexpr double kStandingStill = 1e-9;

/// The body when a stroke began.
struct StrokeStart {
    int firstTriangle = 0;  ///< first slot of the stroke's triangles
    double restVolume = 0;  ///< rest volume of the body [m^3]
};

/// The current or last stroke of the blade. Its functions take the body that it cuts.
struct Stroke {
    /// Begins the next stroke, at a blade.
    void begin(CutBody& body, const Blade& at);
    /// Goes on with the stroke that made a slit, from its end, with the blade along that.
    void goOnFrom(CutBody& body, const SlitFront& front, const Blade& at);
    /// Makes every group take a step to the commanded blade.
    CutResult advance(CutBody& body, Gate gate);
    /// Ends the stroke: see Cutter::finish().
    CutResult finish(CutBody& body);
    /// Makes the postponed ties of all groups, in the rest shape.
    void makeWaitingTies(CutBody& body);

    int number = 0;                     ///< as in wall labels
    bool mayResume = true;              ///< a step that fails may start behind the front
    int unused = 0;                     ///< number of the next stroke that cuts
    int transit = 0;                    ///< number of the last transit of any group, ever
    bool goesOn = false;                ///< it is in progress
    StrokeStart start{};                ///< the body when it began
    Blade blade{};                      ///< its last command
    std::vector<GroupStroke> groups{};  ///< the stroke by group of pieces
    std::vector<RungNode> rung{};       ///< rungs of all groups in turn
    std::optional<Cleanup> cleanup{};   ///< its clean-up, once it has cut

    /// Takes note that it has cut.
    void noteWalls() { unused = std::max(unused, number + 1); }

  private:
    void divideGroups(CutBody& body);
    void holdLivingVertices(const CutBody& body);
    void joinRungs();

    // What else a step and a stroke do, in stroke_end.cpp. Each adds its changes to `delta`.
    CleanupStatistics cleanUpBehindFront(CutBody& body, CutDelta& delta);
    CleanupStatistics cleanUpAtEnd(CutBody& body, CutDelta& delta);
    Debris removeDebris(CutBody& body, CutDelta& delta) const;
};

/// Patches the wounds of the open cut. Walls without a patch become part of the body. Adds the
/// changes to `delta`.
WoundClosing closeWounds(CutBody& body, CutDelta& delta);
/// Removes short edges at some triangles between strokes. Returns the change.
CutDelta mend(CutBody& body, const std::vector<int>& triangles);
/// Removes a piece between strokes, by its number among the cutter's; -1 is none. Returns the
/// change.
CutDelta removePiece(CutBody& body, int piece);

}  // namespace kerf::cut
