#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/run/parts/snapshot.h"

namespace kerf {

/// A gesture that changes the body and may go on in further commands: one undo takes all back.
enum class BodyGesture { none, placement, hands, pins };

/// A change that a person made, and how to take it back.
struct UndoEntry {
    /// A parameter that went from one value to another.
    struct ParamChange {
        std::string param;
        ParamValue before;
        ParamValue after;
    };
    /// A material that gave parameters other values.
    struct MaterialChange {
        std::string material;  ///< its label
        std::vector<ParamChange> params;
    };
    /// Vertices that were pinned or freed, of the mesh as it is between the changes of the body
    /// before and after: see UndoHistory::followCut.
    struct PinChange {
        Pins before;
        Pins after;
    };
    /// Boxes that were added, changed or removed: all there were and are.
    struct BoxesChange {
        std::vector<StaticBox> before;
        std::vector<StaticBox> after;
        int changed = -1;  ///< number of the box that was changed; -1 for none
    };
    /// A cut, a grab, moved pins, a restart or a placement. `after` is known while it is undone.
    struct BodySnapshotChange {
        SnapshotPointer before;
        SnapshotPointer after;
        BodyGesture gesture = BodyGesture::none;
        std::vector<ParamChange> params = {};  ///< that followed the size
    };

    std::string name;  ///< as people read it: "Cut 2", "Gravity: none"
    double time = 0;   ///< simulated, when it happened [s]
    std::variant<ParamChange, MaterialChange, PinChange, BoxesChange, BodySnapshotChange> change;
};

/// The changes of a simulation in their order. The first done() of them are in force, the others
/// undone. Where they need more than the budget the oldest changes are forgotten.
class UndoHistory {
  public:
    /// Sets the budget [bytes]; 0, as at the start, keeps nothing at all.
    void setBudget(std::size_t bytes);
    bool keeps() const { return budget_ > 0; }
    std::size_t budget() const { return budget_; }
    /// Memory of all snapshots (shared ones once), pins and boxes [bytes].
    std::size_t bytes() const { return bytesFrom(0); }
    /// Changes that were forgotten to keep to the budget.
    int forgotten() const { return forgotten_; }

    const std::vector<UndoEntry>& entries() const { return entries_; }
    std::size_t done() const { return done_; }
    /// Grows with each change that was made anew, or forgotten: while it stays, what was undone can
    /// be brought back.
    int additions() const { return additions_; }
    bool canUndo() const { return done_ > 0; }
    bool canRedo() const { return done_ < entries_.size(); }

    /// A change was made; those that were undone are lost.
    void add(UndoEntry entry);
    /// The last change where it is of this kind and nothing is undone: more of the same gesture may
    /// give it a new end. Else null.
    template <class Change>
    Change* continued() {
        return canUndo() && !canRedo() ? std::get_if<Change>(&entries_[done_ - 1].change) : nullptr;
    }
    /// After each step of a cut, which may go on behind other changes: pins that were changed, or
    /// of which a change was undone, since the last change of the body follow it.
    void followCut(const SurfaceMesh& mesh, const CutDelta& delta);
    void renameLast(std::string name) { entries_[done_ - 1].name = std::move(name); }
    /// Something was done that is not kept: it can't be taken back, nor what was before it.
    void forgetAll();
    void clear();

    /// The change to take back next; markUndone() once that is done.
    const UndoEntry& lastDone() const { return entries_[done_ - 1]; }
    /// Marks that change as undone. `after` is the body as it was until now, for a change of it.
    void markUndone(SnapshotPointer after);
    /// The change to bring back next; markRedone() once that is done.
    const UndoEntry& firstUndone() const { return entries_[done_]; }
    void markRedone();

  private:
    std::size_t bytesFrom(std::size_t oldest) const;
    void keepToBudget();

    std::vector<UndoEntry> entries_;
    std::size_t done_ = 0;
    std::size_t budget_ = 0;
    int forgotten_ = 0;
    int additions_ = 0;
};

/// The name of a change of a parameter: "Time step: 0.002 s", "Floor: none", "Density of model 2:
/// 900 kg/m^3".
std::string nameOfChange(std::string_view param, const ParamValue& value);

}  // namespace kerf
