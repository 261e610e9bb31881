#pragma once

#include "sim/base/params.h"
#include "sim/contact/static_box.h"
#include "sim/run/parts/pins.h"

namespace kerf {

struct Snapshot;
using SnapshotPointer = std::shared_ptr<const Snapshot>;

/// A gesture that changes the body and may continue in further commands: one undo reverts all.
enum class BodyGesture { none, placement, hands, pins };

/// A change by a person, and how to revert it.
struct UndoEntry {
    /// A change of a parameter.
    struct ParamChange {
        std::string param;
        ParamValue before;
        ParamValue after;
    };
    /// A material that changed parameters.
    struct MaterialChange {
        std::string material;  ///< its label
        std::vector<ParamChange> params;
    };
    /// Vertices that were pinned, moved, pushed or freed, in the mesh between the previous and the
    /// next change of the body: see UndoHistory::followCut.
    struct PinChange {
        Pins before;
        Pins after;
    };
    /// Boxes that were added, changed or removed: all boxes before and after.
    struct BoxesChange {
        std::vector<StaticBox> before;
        std::vector<StaticBox> after;
        int changed = -1;  ///< number of the box that was changed; -1 for none
    };
    /// A cut, a grab, moved pins, a removed piece, a restart or a placement. `after` is known while
    /// it is undone.
    struct BodySnapshotChange {
        SnapshotPointer before;
        SnapshotPointer after;
        BodyGesture gesture = BodyGesture::none;
        std::vector<ParamChange> params = {};  ///< that were adapted to the size
        int removedPiece = -1;                 ///< its number before that; -1 for none
    };

    std::string name;  ///< for display: "Cut 2", "Gravity: none"
    double time = 0;   ///< simulated time of the change [s]
    std::variant<ParamChange, MaterialChange, PinChange, BoxesChange, BodySnapshotChange> change;
};

/// The changes of a simulation in order. The first done() of them are applied, the others undone.
/// Beyond the budget the oldest changes are dropped.
class UndoHistory {
  public:
    /// Sets the budget [bytes]; 0, the default, keeps nothing.
    void setBudget(std::size_t bytes);
    bool keeps() const { return budget_ > 0; }
    std::size_t budget() const { return budget_; }
    /// Memory of all snapshots (shared ones once), pins and boxes [bytes].
    std::size_t bytes() const { return bytesFrom(0); }
    /// Changes that were dropped to keep the budget.
    int forgotten() const { return forgotten_; }

    const std::vector<UndoEntry>& entries() const { return entries_; }
    std::size_t done() const { return done_; }
    /// Grows with each new or dropped change: while it is constant, undone changes can be redone.
    int additions() const { return additions_; }
    bool canUndo() const { return done_ > 0; }
    bool canRedo() const { return done_ < entries_.size(); }

    /// Adds a change; undone ones are lost.
    void add(UndoEntry entry);
    /// The last change, if it is of this kind and nothing is undone: the same gesture may extend
    /// it. Else null.
    template <class Change>
    Change* continued() {
        return canUndo() && !canRedo() ? std::get_if<Change>(&entries_[done_ - 1].change) : nullptr;
    }
    /// After each step of a cut, which may continue after other changes: updates pins that were
    /// changed, or whose change was undone, since the last change of the body.
    void followCut(const SurfaceMesh& mesh, const CutDelta& delta);
    void renameLast(std::string name) { entries_[done_ - 1].name = std::move(name); }
    /// After a change that is not kept: neither it nor earlier ones can be undone.
    void forgetAll();
    void clear();

    /// The change to undo next; call markUndone() after that.
    const UndoEntry& lastDone() const { return entries_[done_ - 1]; }
    /// Marks that change as undone. `after`: the body until now, for a change of it.
    void markUndone(SnapshotPointer after);
    /// The change to redo next; call markRedone() after that.
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

/// "(1, 0, -2.5)".
std::string textOf(const Vec3& vector);
/// The name of a change of a parameter: "Time step: 0.002 s", "Floor: none", "Density of model 2:
/// 900 kg/m^3".
std::string nameOfChange(std::string_view param, const ParamValue& value);

}  // namespace kerf
