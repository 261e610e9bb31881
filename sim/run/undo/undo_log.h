#pragma once

#include "sim/run/parts/box_edit.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/undo/undo_history.h"

namespace kerf {

/// The changes of a person, entry by entry: continued gestures extend their entry, and a stroke is
/// one, however often it cuts.
class UndoLog {
  public:
    UndoHistory& history() { return history_; }
    const UndoHistory& history() const { return history_; }
    /// Drops everything except the budget.
    void clear();

    /// The present body; never null. Copied only if it differs from the last snapshot.
    SnapshotPointer capture(RunningBody& body);
    /// The present body. Null if nothing is kept, or if a snapshot would not fit, so that a large
    /// body is not copied in vain.
    SnapshotPointer captureForUndo(RunningBody& body);
    /// The state is about to differ from the last snapshot.
    void touch() { current_.reset(); }
    /// The body was set to a snapshot.
    void isAt(const SnapshotPointer& snapshot) { current_ = snapshot; }

    /// Changes from one value to another; `continues`: with the gesture of the last one. `time`:
    /// simulated [s].
    void noteParam(const std::string& param, const ParamValue& before, const ParamValue& after,
                   bool continues, double time);
    /// A material of that label changes a parameter, perhaps after others.
    void noteMaterial(const std::string& material, UndoEntry::ParamChange change, double time);
    /// Of pins, motions and forces.
    void notePins(const std::string& name, Pins before, Pins after, bool continues, double time);
    void noteBoxes(std::vector<StaticBox> before, const BoxEdit& edit, double time);
    /// Records a change of the body. `before` is null if no snapshot fits, or none is kept. Reports
    /// one that is too large, so that neither it nor earlier changes can be undone.
    void noteBody(std::string name, SnapshotPointer before, SimulationOutput& output,
                  BodyGesture gesture = BodyGesture::none, int removedPiece = -1);

    /// Whether the last change was such a gesture, which may continue.
    bool continuesBody(BodyGesture gesture);
    /// Records a placement, with the body `before` (see noteBody()) and the parameters before; one
    /// that continues a gesture needs no `before`.
    void notePlacement(const Place& place, SnapshotPointer before,
                       std::vector<UndoEntry::ParamChange> params, SimulationOutput& output);

    /// A stroke counts from its first change of the body, back to where the blade came near it.
    void beginStroke(RunningBody& body);
    void noteCut(SimulationOutput& output);
    /// The blade is lifted, or was never placed.
    void endStroke();

  private:
    UndoHistory history_;
    SnapshotPointer current_;       ///< equal to the present state; null if none is
    SnapshotPointer beforeStroke_;  ///< while the blade is placed and has not changed the body
    bool strokeNoted_ = false;      ///< since the blade was placed
    int cutsSoFar_ = 0;
};

}  // namespace kerf
