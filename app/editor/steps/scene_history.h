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

/// The changes that replaced the whole scene, such as remeshing. The scene before each is kept,
/// with its cuts and its history, so that undo restores all of it; an undone one is kept until the
/// scene before it is changed otherwise.
class SceneHistory {
  public:
    /// The most scenes that are kept: each holds its body, on the GPU too.
    static constexpr std::size_t kMost = 2;

    /// A scene that is not the open one.
    struct Kept {
        std::string name;  ///< of the change between it and the scene next to it
        std::unique_ptr<EditorScene> scene;
        int savedDeeds = 0;      ///< see WorkKeeping::noteSaved()
        int additions = 0;       ///< UndoHistory::additions() of the scene before the change, then
        std::size_t undone = 0;  ///< its changes undone then
        /// The first changes of the scene after the change, which are those before it once more.
        std::size_t repeated = 0;
    };

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
    /// The scene to open next, instead of `now`, with that many saved deeds. There must be one: see
    /// undoes() and redoes().
    Kept undo(std::unique_ptr<EditorScene> now, int savedDeeds);
    Kept redo(std::unique_ptr<EditorScene> now, int savedDeeds);

    /// The number of history rows before those of the open scene.
    std::size_t rowsBefore() const;
    /// The number of changes of the open scene, whose history is `now`, without rows.
    std::size_t withoutRows(const UndoHistory& now) const;
    /// Adds the rows of the other scenes around those of `now`.
    void describe(const EditorScene& now, ui::ChangeList& list) const;

  private:
    std::vector<ui::ChangeRow> rowsOfBefore() const;

    std::vector<Kept> before_;  ///< oldest first
    std::vector<Kept> after_;   ///< the next one last
};

}  // namespace kerf::app
