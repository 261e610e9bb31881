#pragma once

#include "ui/state/file_dialog_state.h"

namespace kerf::app {

/// The logic of a file dialog: its folder, the files offered there, the name, and whether it is
/// valid. Its state is a ui::FileDialogState.
class FileBrowser {
  public:
    /// Opens `folder`, or its nearest readable parent. `name`: proposed.
    FileBrowser(ui::FilePurpose purpose, std::filesystem::path folder, std::string name,
                std::vector<ui::FolderLink> bookmarks);

    const ui::FileDialogState& state() const { return state_; }
    /// The selected file, if it can be opened; empty for none.
    std::filesystem::path selectedFile() const;

    /// Does an action. Returns the file once one is chosen.
    std::optional<std::filesystem::path> take(const ui::FileAction& action);

  private:
    void goTo(const std::filesystem::path& folder, const std::string& select);
    void listRows();
    void select(int row);
    void rename(std::string name);
    void chooseKind(int kind);
    std::optional<std::filesystem::path> accept(bool overwrite);
    std::optional<std::filesystem::path> acceptToOpen(const std::filesystem::path& path);
    std::optional<std::filesystem::path> acceptToWrite(std::filesystem::path path, bool overwrite);
    std::filesystem::path named() const;
    /// The extension of the chosen kind of file, of an export or a film.
    std::string_view endingOfKind() const;
    bool isOffered(const std::filesystem::path& file) const;

    ui::FileDialogState state_;
};

}  // namespace kerf::app
