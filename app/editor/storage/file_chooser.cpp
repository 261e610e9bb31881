#include "app/editor/storage/file_chooser.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/files/export/mesh_formats.h"
#include "app/files/film/film_formats.h"
#include "app/files/io/free_file.h"
#include "app/session/material.h"
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
        case ui::FilePurpose::makeFilm:
            return document + std::string(filmFormats().front().extension);
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

FileChooser::FileChooser(std::filesystem::path here, std::filesystem::path recentFiles)
    : here_(std::move(here)), recent_(std::move(recentFiles)) {}

void FileChooser::browse(ui::FilePurpose purpose, const std::string& document, BrowseFor what) {
    what_ = what;
    recent_.look();
    const std::filesystem::path& last = lastFolder(purpose);
    const bool besideModel = purpose == ui::FilePurpose::exportMesh && !modelFolder_.empty();
    const std::filesystem::path& first = besideModel ? modelFolder_ : here_;
    const std::filesystem::path& folder = last.empty() ? first : last;
    browser_.emplace(purpose, folder, nameFor(purpose, folder, document), bookmarks(purpose));
    if (purpose == ui::FilePurpose::open && last.empty() &&
        offersNothing(folder, browser_->state())) {
        // The bookmarks lead back.
        browser_.emplace(purpose, gpu::dataPath("assets/models"), "", bookmarks(purpose));
    }
    preview_.select({});
}

void FileChooser::setModel(const std::filesystem::path& file) {
    const std::filesystem::path ours = gpu::dataPath("assets");
    const bool isOurs = std::ranges::mismatch(ours, file).in1 == ours.end();
    modelFolder_ = isOurs ? "" : file.parent_path();
}

std::filesystem::path& FileChooser::lastFolder(ui::FilePurpose purpose) {
    if (purpose == ui::FilePurpose::saveMaterial) {
        return materialFolder_;
    }
    return purpose == ui::FilePurpose::open ? lastSource_ : lastTarget_;
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
    add("Here", here_);
    if (const char* home = std::getenv("HOME")) {
        add("Home", home);
    }
    if (purpose == ui::FilePurpose::open) {
        add("Kerf's models", gpu::dataPath("assets/models"));
        add("Kerf's sessions", gpu::dataPath("assets/sessions"));
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
    lastFolder(dialog.purpose) = dialog.folder;
    if (!file) {
        return std::nullopt;
    }
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
        model.files.preview = preview_.lines();
    }
    model.files.recent = recent_.files();
}

}  // namespace kerf::app
