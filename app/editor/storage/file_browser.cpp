#include "app/editor/storage/file_browser.h"

#include <spdlog/fmt/chrono.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "app/files/export/export.h"
#include "app/files/film/film_encoder.h"
#include "app/files/import/model_source.h"
#include "app/regression/expectation.h"
#include "app/session/material.h"
#include "app/session/session.h"
#include "sim/base/containers.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;
using ui::FilePurpose;

/// The kinds that opening offers, by index.
enum OpenKind { kEverything, kModels, kSessions, kAllFiles };

template <class Info>
std::vector<std::string> kindsOf(std::span<const Info> formats) {
    return mapped(formats, [](const Info& info) {
        return fmt::format("{} ({})", info.name, info.extension);
    });
}

/// What a run is exported as.
struct RunKind {
    std::string_view extension;
    std::string_view name;
};

/// Films, and meshes over time.
std::vector<RunKind> runKinds() {
    std::vector<RunKind> kinds = mapped(filmFormats(), [](const FilmFormatInfo& info) {
        return RunKind{info.extension, info.name};
    });
    kinds.push_back({".abc", "Alembic"});
    kinds.push_back({".pvd", "ParaView"});
    return kinds;
}

bool isOfRun(const fs::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    return std::ranges::count(runKinds(), extension, &RunKind::extension) > 0;
}

std::vector<std::string> kindsOf(FilePurpose purpose) {
    switch (purpose) {
        case FilePurpose::open:
            return {"Models and sessions", "Models", "Sessions", "All files"};
        case FilePurpose::saveSession:
        case FilePurpose::saveTest:
            return {"Session (.kerf.json)"};
        case FilePurpose::saveMaterial:
            return {"Material (.material.json)"};
        case FilePurpose::makeFilm:
            return kindsOf<RunKind>(runKinds());
        case FilePurpose::exportMesh:
        case FilePurpose::none:
            break;
    }
    return kindsOf(meshFormats());
}

/// Whether a file is a session or a material, and no other JSON: its "format" comes first.
bool isOfKerf(const fs::path& file) {
    constexpr std::size_t kHead = 4096;  // [bytes]
    if (!lowerCase(file.string()).ends_with(".json")) {
        return false;
    }
    std::string head(kHead, '\0');
    std::ifstream(file).read(head.data(), kHead);
    return head.find("\"kerf-") != std::string::npos;
}

/// Numbers by their value: "a2" before "a10". Case does not matter.
bool comesBefore(const std::string& a, const std::string& b) {
    return ::strverscmp(lowerCase(a).c_str(), lowerCase(b).c_str()) < 0;
}

std::string localTime(const fs::directory_entry& entry) {
    std::error_code error;
    const fs::file_time_type written = entry.last_write_time(error);
    if (error) {
        return "";
    }
    const auto time = std::chrono::file_clock::to_sys(written);
    return fmt::format("{:%Y-%m-%d %H:%M}",
                       fmt::localtime(std::chrono::system_clock::to_time_t(time)));
}

std::vector<ui::FolderLink> crumbsOf(const fs::path& folder) {
    std::vector<ui::FolderLink> crumbs;
    fs::path soFar;
    for (const fs::path& part : folder) {
        soFar /= part;
        crumbs.push_back({part == "/" ? "root" : part.string(), soFar});
    }
    return crumbs;
}

bool isFolder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

/// The folder itself, or the next one around it that is there.
fs::path existingFolder(fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder, error).lexically_normal();
    if (!folder.has_filename()) {
        folder = folder.parent_path();  // a slash at the end
    }
    while (!isFolder(folder) && folder.has_relative_path()) {
        folder = folder.parent_path();
    }
    return folder;
}

}  // namespace

FileBrowser::FileBrowser(FilePurpose purpose, fs::path folder, std::string name,
                         std::vector<ui::FolderLink> bookmarks) {
    state_.purpose = purpose;
    state_.bookmarks = std::move(bookmarks);
    state_.kinds = kindsOf(purpose);
    state_.name = std::move(name);
    goTo(existingFolder(std::move(folder)), "");
}

fs::path FileBrowser::selectedFile() const {
    if (state_.selected < 0 || state_.rows[state_.selected].isFolder) {
        return {};
    }
    return state_.folder / state_.rows[state_.selected].name;
}

std::optional<fs::path> FileBrowser::take(const ui::FileAction& action) {
    const auto* accepted = std::get_if<ui::AcceptFile>(&action);
    if (accepted != nullptr) {
        return accept(accepted->overwrite);
    }
    state_.asksToOverwrite = false;
    if (const auto* folder = std::get_if<ui::GoToFolder>(&action)) {
        goTo(existingFolder(folder->folder), "");
    } else if (std::holds_alternative<ui::GoToParentFolder>(action)) {
        goTo(existingFolder(state_.folder.parent_path()), state_.folder.filename().string());
    } else if (const auto* row = std::get_if<ui::SelectFile>(&action)) {
        select(row->row);
    } else if (const auto* move = std::get_if<ui::MoveFileSelection>(&action)) {
        const int last = static_cast<int>(state_.rows.size()) - 1;
        select(std::clamp(state_.selected + move->steps, std::min(0, last), last));
    } else if (const auto* named = std::get_if<ui::NameFile>(&action)) {
        rename(named->name);
    } else if (const auto* kind = std::get_if<ui::ChooseFileKind>(&action)) {
        chooseKind(kind->kind);
    } else if (const auto* perPiece = std::get_if<ui::SetFilePerPiece>(&action)) {
        state_.filePerPiece = perPiece->on;
    } else if (const auto* inScene = std::get_if<ui::SetExportInScene>(&action)) {
        state_.inScene = inScene->on;
    } else if (const auto* film = std::get_if<ui::SetFilmLook>(&action)) {
        state_.film = film->look;
    }
    return std::nullopt;
}

void FileBrowser::goTo(const fs::path& folder, const std::string& select) {
    state_.folder = folder;
    state_.crumbs = crumbsOf(folder);
    state_.selected = -1;
    listRows();
    if (state_.purpose == FilePurpose::open) {
        state_.name.clear();
    }
    for (std::size_t i = 0; i < state_.rows.size() && !select.empty(); ++i) {
        if (state_.rows[i].name == select) {
            state_.selected = static_cast<int>(i);
        }
    }
}

bool FileBrowser::isOffered(const fs::path& file) const {
    const bool session = isOfKerf(file);
    switch (state_.purpose) {
        case FilePurpose::open:
            break;
        case FilePurpose::saveSession:
        case FilePurpose::saveTest:
        case FilePurpose::saveMaterial:
            return session;
        case FilePurpose::exportMesh:
        case FilePurpose::none:
            return meshFormatOf(file).has_value();
        case FilePurpose::makeFilm:
            return isOfRun(file);
    }
    switch (state_.kind) {
        case kEverything:
            return session || isModelFile(file);
        case kModels:
            return isModelFile(file);
        case kSessions:
            return session;
        default:
            return true;
    }
}

void FileBrowser::listRows() {
    state_.rows.clear();
    state_.problem.clear();
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::directory_iterator entry(state_.folder, options, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        std::error_code ignored;
        const bool folder = entry->is_directory(ignored);
        if (name.starts_with('.') || (!folder && !isOffered(entry->path()))) {
            continue;
        }
        const std::uintmax_t bytes = folder ? 0 : entry->file_size(ignored);
        state_.rows.push_back({name, folder, ignored ? 0 : bytes, localTime(*entry)});
    }
    if (error) {
        state_.problem = "This folder can't be read (" + error.message() + ").";
    }
    std::ranges::sort(state_.rows, [](const ui::FileRow& a, const ui::FileRow& b) {
        return a.isFolder != b.isFolder ? a.isFolder : comesBefore(a.name, b.name);
    });
}

void FileBrowser::select(int row) {
    if (row < 0 || row >= static_cast<int>(state_.rows.size())) {
        return;
    }
    state_.selected = row;
    state_.problem.clear();
    if (!state_.rows[row].isFolder) {
        state_.name = state_.rows[row].name;
    } else if (state_.purpose == FilePurpose::open) {
        state_.name = state_.rows[row].name + "/";
    }
}

/// What begins like it is selected: the file is found by typing.
void FileBrowser::rename(std::string name) {
    state_.name = std::move(name);
    state_.problem.clear();
    state_.selected = -1;
    const std::string wanted = lowerCase(state_.name);
    for (std::size_t i = 0; i < state_.rows.size() && !wanted.empty(); ++i) {
        const bool fits = state_.purpose == FilePurpose::open
                              ? lowerCase(state_.rows[i].name).starts_with(wanted)
                              : state_.rows[i].name == state_.name;
        if (fits) {
            state_.selected = static_cast<int>(i);
            break;
        }
    }
}

void FileBrowser::chooseKind(int kind) {
    if (kind < 0 || kind >= static_cast<int>(state_.kinds.size())) {
        return;
    }
    state_.kind = kind;
    if (state_.purpose == FilePurpose::exportMesh || state_.purpose == FilePurpose::makeFilm) {
        state_.name = fs::path(state_.name).replace_extension(endingOfKind()).string();
    }
    const std::string kept = state_.selected < 0 ? "" : state_.rows[state_.selected].name;
    state_.selected = -1;
    listRows();
    rename(state_.purpose == FilePurpose::open ? kept : state_.name);
}

std::string_view FileBrowser::endingOfKind() const {
    return state_.purpose == FilePurpose::makeFilm ? runKinds()[state_.kind].extension
                                                   : meshFormats()[state_.kind].extension;
}

fs::path FileBrowser::named() const {
    fs::path path = state_.name;
    const char* const home = std::getenv("HOME");
    if (home != nullptr && (state_.name == "~" || state_.name.starts_with("~/"))) {
        path = fs::path(home) / fs::path(state_.name).lexically_relative("~");
    }
    return (state_.folder / path).lexically_normal();
}

std::optional<fs::path> FileBrowser::accept(bool overwrite) {
    // Something selected by typing a part of its name counts in full.
    const bool found = state_.purpose == FilePurpose::open && state_.selected >= 0;
    const fs::path path = found ? state_.folder / state_.rows[state_.selected].name : named();
    if (state_.name.empty() && !found) {
        state_.problem = "Select a file or type its name.";
        return std::nullopt;
    }
    if (isFolder(path)) {
        goTo(existingFolder(path), "");
        return std::nullopt;
    }
    return state_.purpose == FilePurpose::open ? acceptToOpen(path)
                                               : acceptToWrite(path, overwrite);
}

std::optional<fs::path> FileBrowser::acceptToOpen(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) {
        state_.problem = "There is no file named " + path.filename().string() + " in this folder.";
        return std::nullopt;
    }
    return path;
}

std::optional<fs::path> FileBrowser::acceptToWrite(fs::path path, bool overwrite) {
    const bool test = state_.purpose == FilePurpose::saveTest;
    if ((test || state_.purpose == FilePurpose::saveSession) &&
        !path.string().ends_with(kSessionEnding)) {
        path += kSessionEnding;
    }
    if (state_.purpose == FilePurpose::saveMaterial && !path.string().ends_with(kMaterialEnding)) {
        path += kMaterialEnding;
    }
    const bool needsEnding = (state_.purpose == FilePurpose::exportMesh && !meshFormatOf(path)) ||
                             (state_.purpose == FilePurpose::makeFilm && !isOfRun(path));
    if (needsEnding) {
        path += endingOfKind();
    }
    if (!isFolder(path.parent_path())) {
        state_.problem = "The folder " + path.parent_path().string() + " doesn't exist.";
        return std::nullopt;
    }
    std::error_code error;
    const fs::path first = state_.filePerPiece ? pieceFile(path, 0) : path;
    const bool taken =
        fs::exists(first, error) || (test && fs::exists(expectationFolder(path), error));
    if (!overwrite && taken) {
        state_.asksToOverwrite = true;
        return std::nullopt;
    }
    return path;
}

}  // namespace kerf::app
