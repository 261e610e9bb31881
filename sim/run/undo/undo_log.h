#pragma once

#include <string>

#include "sim/run/parts/box_edit.h"
#include "sim/run/parts/running_body.h"
#include "sim/run/parts/simulation_parts.h"
#include "sim/run/undo/undo_history.h"

namespace kerf {

/// The changes of a person, entry by entry: gestures that go on extend their entry, and a stroke is
/// one, however often it cuts.
class UndoLog {
  public:
    UndoHistory& history() { return history_; }
    const UndoHistory& history() const { return history_; }
    /// Forgets everything but the budget.
    void clear();

    /// The body as it is; never null. Taken anew only where something differs from the last one.
    SnapshotPointer capture(RunningBody& body);
    /// The body as it is. Null where nothing is kept, or where a snapshot would not fit: a large
    /// body is not copied for nothing.
    SnapshotPointer captureForUndo(RunningBody& body);
    /// Something is about to differ from the last snapshot.
    void touch() { current_.reset(); }
    /// The body has become that of a snapshot.
    void isAt(const SnapshotPointer& snapshot) { current_ = snapshot; }

    /// Changes from one value to another; `continues`: with the gesture of the last one. `time`:
    /// simulated [s].
    void noteParam(const std::string& param, const ParamValue& before, const ParamValue& after,
                   bool continues, double time);
    /// A material of that label changes a parameter, as it may have changed others just before.
    void noteMaterial(const std::string& material, UndoEntry::ParamChange change, double time);
    void notePins(Pins before, Pins after, const Pin& pin, double time);
    void noteBoxes(std::vector<StaticBox> before, const BoxEdit& edit, double time);
    /// Notes a change of the body. `before` is null where no snapshot fits, or none is kept. Says
    /// where one is too large, so that neither it nor what was before can be taken back.
    void noteBody(std::string name, SnapshotPointer before, SimulationOutput& output,
                  BodyGesture gesture = BodyGesture::none);

    /// Whether the last change was such a gesture, which may go on.
    bool continuesBody(BodyGesture gesture);
    /// A placement, before which the body was `before` (see noteBody()) and the parameters others;
    /// one that goes on with a gesture needs no `before`.
    void notePlacement(const Place& place, SnapshotPointer before,
                       std::vector<UndoEntry::ParamChange> params, SimulationOutput& output);

    /// A stroke counts from its first change of the body, back to where the blade came near it.
    void beginStroke(RunningBody& body);
    void noteCut(SimulationOutput& output);
    /// The blade is lifted, or was never placed.
    void endStroke();

  private:
    UndoHistory history_;
    SnapshotPointer current_;       ///< equal to the state as it is; null where none is known to be
    SnapshotPointer beforeStroke_;  ///< while the blade is placed and has not changed the body
    bool strokeNoted_ = false;      ///< since the blade was placed
    int cutsSoFar_ = 0;
};

}  // namespace kerf
