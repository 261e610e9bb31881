#pragma once

#include "ui/state/action.h"

namespace kerf::ui {

/// The file dialog: bookmarks, folders and files, a preview, a name, options. By keyboard: typing
/// names, arrows select, Enter accepts, Backspace in an empty name goes up, Esc closes.
class FileDialog {
  public:
    void draw(const FileDialogState& state, std::vector<Action>& actions);
    /// Whether the dialog was open in the last update: then it takes all keys.
    bool isOpen() const { return open_; }

  private:
    void drawCrumbs(const FileDialogState& state, std::vector<Action>& actions);
    void drawBookmarks(const FileDialogState& state, std::vector<Action>& actions);
    void drawRow(const FileDialogState& state, int i, std::vector<Action>& actions);
    void drawRows(const FileDialogState& state, std::vector<Action>& actions);
    void drawName(const FileDialogState& state, std::vector<Action>& actions);
    void drawOptions(const FileDialogState& state, std::vector<Action>& actions);
    void drawButtons(const FileDialogState& state, std::vector<Action>& actions);
    void takeKeys(const FileDialogState& state, std::vector<Action>& actions);

    bool open_ = false;
    bool justOpened_ = false;
    int scrolledTo_ = -1;   ///< the row that was last brought into sight
    std::string text_;      ///< of the name field
    std::string lastName_;  ///< of the state, as last seen
};

}  // namespace kerf::ui
