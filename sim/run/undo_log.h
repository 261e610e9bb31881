#pragma once

#include <string>

#include "sim/run/box_edit.h"
#include "sim/run/undo_history.h"

namespace kerf {

/// The changes of a person, entry by entry: gestures that go on extend their entry, and a stroke is
/// one, however often it cuts.
class UndoLog {
  public:
    /// The fate of a change of the body.
    enum class Noted {
        kept,
        tooLarge,  ///< for the undo memory: neither it nor what was before can be taken back
        nothing,   ///< there is none to note, or none are kept
    };

    UndoHistory& history() { return history_; }
    const UndoHistory& history() const { return history_; }
    /// Forgets everything but the budget.
    void clear();

    /// Changes from one value to another; `continues`: with the gesture of the last one. `time`:
    /// simulated [s].
    void noteParam(const std::string& param, const ParamValue& before, const ParamValue& after,
                   bool continues, double time);
    void notePins(Pins before, Pins after, const Pin& pin, double time);
    void noteBoxes(std::vector<StaticBox> before, const BoxEdit& edit, double time);
    /// Notes a change of the body. `before` is null where no snapshot fits, or none is kept.
    Noted noteBody(std::string name, SnapshotPointer before, double time);

    /// A stroke counts from its first change of the body, back to where the blade came near it.
    bool strokeNeedsSnapshot() const { return !strokeNoted_ && !beforeStroke_; }
    void beginStroke(SnapshotPointer before) { beforeStroke_ = std::move(before); }
    Noted noteCut(double time);
    /// The blade is lifted, or was never placed.
    void endStroke();

  private:
    UndoHistory history_;
    SnapshotPointer beforeStroke_;  ///< while the blade is placed and has not changed the body
    bool strokeNoted_ = false;      ///< since the blade was placed
    int cutsSoFar_ = 0;
};

}  // namespace kerf
