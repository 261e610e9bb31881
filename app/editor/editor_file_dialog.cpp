#include <cstdlib>
#include <utility>

#include "app/editor/editor_state.h"
#include "app/files/free_file.h"
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

void Editor::State::browse(ui::FilePurpose purpose) {
    recent.look();
    const std::filesystem::path& last = lastFolder(purpose);
    const std::filesystem::path& folder = last.empty() ? options.screenshotFolder : last;
    const std::string document = scene == nullptr ? "" : scene->document().name;
    browser.emplace(purpose, folder, nameFor(purpose, folder, document), bookmarks(purpose));
    if (purpose == ui::FilePurpose::open && last.empty() &&
        offersNothing(folder, browser->state())) {
        // The bookmarks lead back.
        browser.emplace(purpose, gpu::dataPath("assets/models"), "", bookmarks(purpose));
    }
    preview.select({});
    settleUpdates = kSettleUpdates;
}

std::vector<ui::FolderLink> Editor::State::bookmarks(ui::FilePurpose purpose) const {
    std::vector<ui::FolderLink> links;
    const auto add = [&](const std::string& label, const std::filesystem::path& folder) {
        std::error_code error;
        if (std::filesystem::is_directory(folder, error)) {
            links.push_back({label, std::filesystem::absolute(folder).lexically_normal()});
        }
    };
    add("Here", options.screenshotFolder);
    if (const char* home = std::getenv("HOME")) {
        add("Home", home);
    }
    if (purpose == ui::FilePurpose::open) {
        add("Kerf's models", gpu::dataPath("assets/models"));
        add("Kerf's sessions", gpu::dataPath("assets/sessions"));
    }
    std::vector<std::filesystem::path> folders = recent.folders();
    folders.resize(std::min(folders.size(), kMostRecentFolders));
    for (const std::filesystem::path& folder : folders) {
        add(folder.filename().string(), folder);
    }
    return links;
}

void Editor::State::applyToFiles(const ui::FileAction& action) {
    settleUpdates = kSettleUpdates;
    if (const auto* wanted = std::get_if<ui::OpenFile>(&action)) {
        open(wanted->file);
    } else if (std::holds_alternative<ui::CloseFileDialog>(action)) {
        browser.reset();
        preview.select({});
    } else if (browser) {
        const std::optional<std::filesystem::path> taken = browser->take(action);
        lastFolder(browser->state().purpose) = browser->state().folder;
        if (taken) {
            takeFile(*taken);
        }
    }
}

void Editor::State::takeFile(const std::filesystem::path& file) {
    const ui::FileDialogState dialog = browser->state();
    browser.reset();
    preview.select({});
    switch (dialog.purpose) {
        case ui::FilePurpose::open:
            open(file);
            return;
        case ui::FilePurpose::saveSession:
            saveSession(file);
            recent.add(file);
            return;
        case ui::FilePurpose::saveTest:
            saveTest(file);
            recent.add(file);
            return;
        case ui::FilePurpose::exportMesh:
            exportBody(file, dialog.filePerPiece);
            return;
        case ui::FilePurpose::none:
            return;
    }
}

void Editor::State::followPreview() {
    if (browser && browser->state().purpose == ui::FilePurpose::open) {
        preview.select(browser->selectedFile());
    }
    if (preview.advance()) {
        settleUpdates = kSettleUpdates;
    }
}

void Editor::State::answer(int choice) {
    if (asked) {
        const Asked answered = *std::exchange(asked, std::nullopt);
        settleUpdates = kSettleUpdates;
        answered.answer(choice);
    }
}

}  // namespace kerf::app
