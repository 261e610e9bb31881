#include "app/editor/file_chooser.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/files/free_file.h"
#include "app/files/mesh_formats.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

constexpr std::size_t kMostRecentFolders = 5;

/// The name that a dialog proposes.
std::string nameFor(ui::FilePurpose purpose, const std::filesystem::path& folder,
                    const std::string& document) {
    switch (purpose) {
        case ui::FilePurpose::saveSession:
            return freeFile(folder, document, ".kerf.json").filename().string();
        case ui::FilePurpose::saveTest:
            return document + ".kerf.json";  // replaced more often than the others
        case ui::FilePurpose::exportMesh:
            return document + std::string(meshFormats().front().extension);
        case ui::FilePurpose::open:
        case ui::FilePurpose::none:
            break;
    }
    return "";
}

/// Whether a newcomer would find nothing there: it is empty, or where Kerf itself lies.
bool offersNothing(const std::filesystem::path& folder, const ui::FileDialogState& state) {
    std::error_code error;
    return state.rows.empty() || std::filesystem::equivalent(folder, gpu::dataPath("."), error);
}

}  // namespace

FileChooser::FileChooser(std::filesystem::path here, std::filesystem::path recentFiles)
    : here_(std::move(here)), recent_(std::move(recentFiles)) {}

void FileChooser::browse(ui::FilePurpose purpose, const std::string& document,
                         bool testGetsPicture) {
    testGetsPicture_ = testGetsPicture;
    recent_.look();
    const std::filesystem::path& last = lastFolder(purpose);
    const std::filesystem::path& folder = last.empty() ? here_ : last;
    browser_.emplace(purpose, folder, nameFor(purpose, folder, document), bookmarks(purpose));
    if (purpose == ui::FilePurpose::open && last.empty() &&
        offersNothing(folder, browser_->state())) {
        // The bookmarks lead back.
        browser_.emplace(purpose, gpu::dataPath("assets/models"), "", bookmarks(purpose));
    }
    preview_.select({});
}

std::filesystem::path& FileChooser::lastFolder(ui::FilePurpose purpose) {
    return purpose == ui::FilePurpose::open ? lastSource_ : lastTarget_;
}

std::vector<ui::FolderLink> FileChooser::bookmarks(ui::FilePurpose purpose) const {
    std::vector<ui::FolderLink> links;
    const auto add = [&](const std::string& label, const std::filesystem::path& folder) {
        std::error_code error;
        if (std::filesystem::is_directory(folder, error)) {
            links.push_back({label, std::filesystem::absolute(folder).lexically_normal()});
        }
    };
    add("Here", here_);
    if (const char* home = std::getenv("HOME")) {
        add("Home", home);
    }
    if (purpose == ui::FilePurpose::open) {
        add("Kerf's models", gpu::dataPath("assets/models"));
        add("Kerf's sessions", gpu::dataPath("assets/sessions"));
    }
    std::vector<std::filesystem::path> folders = recent_.folders();
    folders.resize(std::min(folders.size(), kMostRecentFolders));
    for (const std::filesystem::path& folder : folders) {
        add(folder.filename().string(), folder);
    }
    return links;
}

std::optional<ChosenFile> FileChooser::take(const ui::FileAction& action) {
    if (const auto* wanted = std::get_if<ui::OpenFile>(&action)) {
        return ChosenFile{ui::FilePurpose::open, wanted->file};
    }
    if (std::holds_alternative<ui::CloseFileDialog>(action)) {
        close();
    }
    if (!browser_) {
        return std::nullopt;
    }
    const std::optional<std::filesystem::path> file = browser_->take(action);
    const ui::FileDialogState& dialog = browser_->state();
    lastFolder(dialog.purpose) = dialog.folder;
    if (!file) {
        return std::nullopt;
    }
    const ChosenFile chosen{dialog.purpose, *file, dialog.filePerPiece, dialog.inScene,
                            testGetsPicture_};
    close();
    return chosen;
}

void FileChooser::close() {
    browser_.reset();
    preview_.select({});
}

bool FileChooser::followPreview() {
    if (browser_ && browser_->state().purpose == ui::FilePurpose::open) {
        preview_.select(browser_->selectedFile());
    }
    return preview_.advance();
}

void FileChooser::describe(ui::PanelModel& model) const {
    model.recentFiles = recent_.files();
    if (browser_) {
        model.files = browser_->state();
        model.files.preview = preview_.lines();
    }
}

}  // namespace kerf::app
