#include "app/editor/storage/file_chooser.h"

#include <cstdlib>
#include <regex>

#include "app/files/export/mesh_formats.h"
#include "app/files/film/film_encoder.h"
#include "app/files/io/file_io.h"
#include "app/session/material.h"
#include "app/session/session.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

constexpr std::size_t kMostRecentFolders = 5;

/// "ball-cut.obj", numbered if taken: never the name of what was opened.
std::string nameOfCut(const std::filesystem::path& folder, const std::string& document,
                      std::string_view ending) {
    static const std::regex kOurs("-cut(-[0-9]+)?$");
    return numberedFile(folder, std::regex_replace(document, kOurs, "") + "-cut",
                        std::string(ending))
        .filename()
        .string();
}

/// The key of the folder last used for such files, in the settings.
std::string kindOf(ui::FilePurpose purpose) {
    static constexpr std::array kKinds{"",        "open",   "sessions", "sessions",
                                       "exports", "videos", "materials"};
    return kKinds[static_cast<std::size_t>(purpose)];
}

/// The name that a dialog proposes.
std::string nameFor(ui::FilePurpose purpose, const std::filesystem::path& folder,
                    const std::string& document) {
    switch (purpose) {
        case ui::FilePurpose::saveSession:
            return nameOfCut(folder, document, kSessionEnding);
        case ui::FilePurpose::saveTest:
            return document + ".kerf.json";  // replaced more often than the others
        case ui::FilePurpose::exportMesh:
            return nameOfCut(folder, document, meshFormats().front().extension);
        case ui::FilePurpose::makeFilm:
            return nameOfCut(folder, document, filmFormats().front().extension);
        case ui::FilePurpose::saveMaterial:
            return document + std::string(kMaterialEnding);
        case ui::FilePurpose::open:
        case ui::FilePurpose::none:
            break;
    }
    return "";
}

/// A folder's last `parts` names: "a/models".
std::string lastNames(const std::filesystem::path& folder, int parts) {
    std::filesystem::path names;
    std::filesystem::path at = folder;
    for (; parts > 0 && at.has_relative_path(); --parts, at = at.parent_path()) {
        names = names.empty() ? at.filename() : at.filename() / names;
    }
    return names.empty() ? folder.string() : names.string();
}

/// Gives folders of one name as many names of the folders around them as tell them apart.
void tellApart(std::vector<ui::FolderLink>& links, std::size_t fixed) {
    constexpr int kMostParts = 8;
    const auto isTwice = [&](const ui::FolderLink& link) {
        return std::ranges::count(links, link.label, &ui::FolderLink::label) > 1;
    };
    for (int parts = 2; parts <= kMostParts; ++parts) {
        std::vector<std::size_t> same;
        for (std::size_t i = fixed; i < links.size(); ++i) {
            if (isTwice(links[i])) {
                same.push_back(i);
            }
        }
        for (const std::size_t i : same) {
            links[i].label = lastNames(links[i].folder, parts);
        }
    }
}

/// Whether a newcomer would find nothing there: it is empty, or where Kerf itself lies.
bool offersNothing(const std::filesystem::path& folder, const ui::FileDialogState& state) {
    std::error_code error;
    return state.rows.empty() || std::filesystem::equivalent(folder, gpu::dataPath("."), error);
}

}  // namespace

bool isOurs(const std::filesystem::path& file) {
    const std::filesystem::path ours = gpu::dataPath("assets");
    return std::ranges::mismatch(ours, file).in1 == ours.end();
}

FileChooser::FileChooser(std::filesystem::path here, std::filesystem::path recentFiles,
                         std::map<std::string, std::string>& folders)
    : here_(std::move(here)), recent_(std::move(recentFiles)), folders_(folders) {}

void FileChooser::browse(ui::FilePurpose purpose, const std::string& document, BrowseFor what) {
    what_ = what;
    recent_.look();
    const std::filesystem::path folder = firstFolder(purpose);
    browser_.emplace(purpose, folder, nameFor(purpose, folder, document), bookmarks(purpose));
    if (purpose == ui::FilePurpose::open && folder == here_ &&
        offersNothing(folder, browser_->state())) {
        // The bookmarks lead back.
        browser_.emplace(purpose, gpu::dataPath("assets/models"), "", bookmarks(purpose));
    }
    preview_.select({});
}

void FileChooser::browseAgain(const ChosenFile& chosen) {
    what_ = chosen.what;
    browser_.emplace(chosen.purpose, chosen.file.parent_path(), chosen.file.filename().string(),
                     bookmarks(chosen.purpose));
}

void FileChooser::setSource(const std::filesystem::path& file) {
    sourceFolder_ = isOurs(file) ? "" : file.parent_path();
}

std::filesystem::path FileChooser::firstFolder(ui::FilePurpose purpose) const {
    const auto last = folders_.find(kindOf(purpose));
    std::error_code error;
    if (last != folders_.end() && std::filesystem::is_directory(last->second, error)) {
        return last->second;
    }
    if (purpose == ui::FilePurpose::saveMaterial) {
        return materialFolder_;
    }
    return purpose == ui::FilePurpose::open || sourceFolder_.empty() ? here_ : sourceFolder_;
}

std::vector<ui::FolderLink> FileChooser::bookmarks(ui::FilePurpose purpose) const {
    std::vector<ui::FolderLink> links;
    const auto add = [&](const std::string& label, const std::filesystem::path& folder) {
        std::error_code error;
        const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
        if (std::filesystem::is_directory(folder, error) &&
            std::ranges::find(links, whole, &ui::FolderLink::folder) == links.end()) {
            links.push_back({label, whole});
        }
    };
    add("Current folder", here_);
    if (const char* home = std::getenv("HOME")) {
        add("Home", home);
    }
    if (purpose == ui::FilePurpose::open) {
        add("Sample models", gpu::dataPath("assets/models"));
        add("Sample sessions", gpu::dataPath("assets/sessions"));
    }
    const std::size_t named = links.size();
    std::vector<std::filesystem::path> folders = recent_.folders();
    folders.resize(std::min(folders.size(), kMostRecentFolders));
    for (const std::filesystem::path& folder : folders) {
        add(folder.filename().string(), folder);
    }
    tellApart(links, named);
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
    if (!file) {
        return std::nullopt;
    }
    folders_[kindOf(dialog.purpose)] = file->parent_path().string();
    const ChosenFile chosen{dialog.purpose, *file, dialog.filePerPiece,
                            dialog.inScene, what_, dialog.film};
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
    if (browser_) {
        model.files = browser_->state();
        model.files.adds = what_ == BrowseFor::addition;
        model.files.onePiece = what_ == BrowseFor::selectedPiece;
        model.files.preview = preview_.lines();
    }
    model.files.recent = recent_.files();
}

}  // namespace kerf::app
