#pragma once

#include "app/editor/storage/file_browser.h"
#include "app/editor/storage/file_preview.h"
#include "app/editor/storage/settings_file.h"
#include "ui/state/panel_model.h"

namespace kerf::app {

/// The purpose of a file that is opened or saved.
enum class BrowseFor : std::uint8_t {
    itself,           ///< nothing
    addition,         ///< of one to be opened: its model is added to the scene
    testWithPicture,  ///< of a test: add a picture of its end
    selectedPiece,    ///< of an export: only that one
};

/// A file chosen by the user, and its purpose.
struct ChosenFile {
    ui::FilePurpose purpose = ui::FilePurpose::none;
    std::filesystem::path file;
    bool filePerPiece = false;  ///< of an export
    bool inScene = false;       ///< of an export: in metres of the scene
    BrowseFor what = BrowseFor::itself;
    ui::FilmLook film{};  ///< of a film
};

/// Whether a file comes with Kerf.
bool isOurs(const std::filesystem::path& file);

/// Lets the user choose files: in the dialog, which begins in the folder last used for that kind of
/// files, or among the recent ones.
class FileChooser {
  public:
    /// Starts in the folder `here`. For `recentFiles` see RecentFiles, for `folders`
    /// ui::Settings::folders, which must outlive it.
    FileChooser(std::filesystem::path here, std::filesystem::path recentFiles,
                std::map<std::string, std::string>& folders);

    /// Opens the dialog. It proposes a name for the open `document`, "" while there is none.
    void browse(ui::FilePurpose purpose, const std::string& document,
                BrowseFor what = BrowseFor::itself);
    /// Opens the dialog again with what was chosen in it, since the file could not be written.
    void browseAgain(const ChosenFile& chosen);
    /// The open file, beside which saving begins until another folder is chosen. An empty path for
    /// none; what comes with Kerf counts as none.
    void setSource(const std::filesystem::path& file);
    /// The folder for materials until another one is chosen.
    void setMaterialFolder(const std::filesystem::path& folder) { materialFolder_ = folder; }
    bool isOpen() const { return browser_.has_value(); }
    /// Does an action of the dialog. Returns the file once one is chosen.
    std::optional<ChosenFile> take(const ui::FileAction& action);
    /// Checks which of the recent files are still there.
    void lookForRecent() { recent_.look(); }
    /// Puts a file first among the recent ones.
    void addRecent(const std::filesystem::path& file) { recent_.add(file); }

    /// Follows the preview of the selected file. Whether it has changed since the last call.
    bool followPreview();
    /// Whether a preview is being made.
    bool previews() const { return preview_.working(); }
    /// Sets what the dialog shows, and the recent files.
    void describe(ui::PanelModel& model) const;

  private:
    void close();
    std::filesystem::path firstFolder(ui::FilePurpose purpose) const;
    std::vector<ui::FolderLink> bookmarks(ui::FilePurpose purpose) const;

    std::filesystem::path here_;
    RecentFiles recent_;
    std::map<std::string, std::string>& folders_;  ///< last used, by kind
    std::filesystem::path sourceFolder_;           ///< see setSource()
    std::filesystem::path materialFolder_;
    std::optional<FileBrowser> browser_;  ///< while the dialog is open
    FilePreview preview_;
    BrowseFor what_ = BrowseFor::itself;  ///< see ChosenFile
};

}  // namespace kerf::app
