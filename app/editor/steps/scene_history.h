#pragma once

#include "app/scene/document/document_loading.h"
#include "app/scene/editor_scene.h"
#include "ui/state/panel_model.h"

namespace kerf {
class UndoHistory;
}

namespace kerf::app {

/// A model that was repaired on opening.
struct Mended {
    ModelFault fault;    ///< why
    OpeningOrder order;  ///< how it is opened
    std::string change;  ///< what was done
};

/// The scenes that replaced each other, such as by remeshing, and a cursor at the open one. Each
/// keeps its cuts and its history, so that undo restores all of it; an undone one is kept until the
/// scene before it is changed otherwise.
class SceneHistory {
  public:
    /// The most scenes that are kept: each holds its body, on the GPU too.
    static constexpr std::size_t kMost = 2;

    /// An exchange requested by undo or redo, done between two steps.
    enum class Exchange { none, back, forth };
    Exchange wanted = Exchange::none;
    std::optional<Mended> mended;       ///< the model that is open, if it was
    std::optional<Mended> beingMended;  ///< the one that is being opened

    /// Forgets all but what is being opened.
    void clear();
    /// `before` was replaced by a new scene. Undone ones are lost.
    void add(std::string name, std::unique_ptr<EditorScene> before, int savedDeeds);
    /// All changes of the open scene, whose history is `now`, repeat those before the exchange.
    void noteRepeated(const UndoHistory& now);
    /// Drops what can't be restored any more after a change of the open scene, whose history is
    /// `now`.
    void follow(const UndoHistory& now);

    /// Whether an undo reverts an exchange: nothing of `now` is left to undo but what is repeated.
    bool undoes(const EditorScene& now) const;
    /// Whether a redo repeats an exchange.
    bool redoes(const EditorScene& now) const;
    /// What is to be opened next instead of a scene.
    struct Next {
        std::string exchange;  ///< its name
        std::unique_ptr<EditorScene> scene;
        int savedDeeds = 0;
    };
    /// Moves the cursor by an exchange, back or forth, away from `now` with that many saved deeds.
    /// There must be one: see undoes() and redoes().
    Next go(Exchange where, std::unique_ptr<EditorScene> now, int savedDeeds);

    /// The name of the exchange that led to the open scene; empty for none.
    const std::string& exchanged() const { return scenes_[at_].name; }
    /// The number of history rows before those of the open scene.
    std::size_t rowsBefore() const;
    /// The number of changes of the open scene, whose history is `now`, without rows.
    std::size_t withoutRows(const UndoHistory& now) const;
    /// Adds the rows of the other scenes around those of `now`.
    void describe(const EditorScene& now, ui::ChangeList& list) const;

  private:
    /// A scene of the list, and the exchange that led to it from the one before.
    struct Kept {
        std::string name;                    ///< of the exchange
        std::unique_ptr<EditorScene> scene;  ///< null for the open one
        int savedDeeds = 0;                  ///< see WorkKeeping::noteSaved()
        // Of the scene before, when it was exchanged: UndoHistory::additions(), changes undone.
        int additions = 0;
        std::size_t undone = 0;
        /// The first changes of this scene, which are those of the scene before once more.
        std::size_t repeated = 0;
    };

    /// What was exchanged for a later scene, undone by now; null if none can come back.
    const Kept* undone(const UndoHistory& now) const;
    std::vector<ui::ChangeRow> rowsOfBefore() const;

    std::vector<Kept> scenes_ = std::vector<Kept>(1);  ///< oldest first
    std::size_t at_ = 0;                               ///< the open one
    int letGo_ = 0;                                    ///< changes, with scenes that were too many
};

}  // namespace kerf::app
