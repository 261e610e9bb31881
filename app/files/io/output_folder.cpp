#include "app/files/io/output_folder.h"

#include <stdlib.h>

#include <system_error>

#include "app/files/io/file_io.h"
#include "sim/base/text.h"

namespace kerf::app {

OutputFolder::OutputFolder(const std::filesystem::path& folder) {
    std::error_code error;
    makeFolders(std::filesystem::absolute(folder, error));
    folder_ = std::filesystem::canonical(folder, error);
    if (error || !std::filesystem::is_directory(folder_)) {
        const std::string why = error ? error.message() : "there is something else";
        throw OutputError(shownPath(folder) +
                          (std::filesystem::is_regular_file(folder, error)
                               ? ": a file stands where a folder should be."
                               : ": this folder could not be made (" + why + ")."));
    }
}

OutputFolder::~OutputFolder() {
    std::error_code error;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
        std::filesystem::remove(*folder, error);  // refused where something lies in it
    }
}

/// Those of its path that are missing. What could not be made is found out by who looks for it.
void OutputFolder::makeFolders(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::path path;
    for (const std::filesystem::path& part : folder) {
        path /= part;
        if (!part.empty() && std::filesystem::create_directory(path, error)) {
            made_.push_back(path);
        }
    }
}

/// Looked at before anything is made or removed there.
std::filesystem::path OutputFolder::insidePath(const std::string& name) const {
    std::filesystem::path file = folder_ / name;
    if (!isNameInside(name) || !leadsInside(folder_, file.parent_path())) {
        throw OutputError(printable(name) + ": it would not lie inside the output folder.");
    }
    return file;
}

std::filesystem::path OutputFolder::pathOf(const std::string& name) {
    std::filesystem::path file = insidePath(name);
    makeFolders(file.parent_path());
    if (!leadsInside(folder_, file)) {
        throw OutputError(printable(name) + ": a link leads out of the output folder; remove it.");
    }
    return file;
}

void OutputFolder::removeUnfinished(const std::string& name) const {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
        if (isUnfinished(entry.path().filename().string(), name)) {
            std::filesystem::remove(entry.path(), error);
        }
    }
}

void OutputFolder::remove(const std::string& name) const {
    std::error_code error;
    std::filesystem::remove(insidePath(name), error);
    if (error) {
        throw OutputError(name + ": an older result could not be removed (" + error.message() +
                          ").");
    }
}

void OutputFolder::write(const std::string& name, std::string_view bytes) {
    writeOutputFile(pathOf(name), bytes);
    written_.push_back(name);
}

TemporaryFolder::TemporaryFolder(const std::string& name) {
    std::error_code error;
    std::string path = (std::filesystem::temp_directory_path(error) / (name + "-XXXXXX")).string();
    if (error || ::mkdtemp(path.data()) == nullptr) {
        throw OutputError("No temporary folder could be made; set TMPDIR to one that exists.");
    }
    path_ = path;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
}

}  // namespace kerf::app
