#include "app/editor/storage/recent_files.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "gpu/data_path.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostListBytes = 1u << 20;

bool isThere(const fs::path& file) {
    std::error_code error;
    return fs::is_regular_file(file, error);
}

std::string contentOf(const fs::path& store) {
    try {
        return store.empty() ? "" : readInputFile(store, kMostListBytes);
    } catch (const InputError&) {  // there is none yet
        return "";
    }
}

}  // namespace

RecentFiles::RecentFiles(fs::path store) : store_(std::move(store)) {
    std::istringstream in(contentOf(store_));
    for (std::string line; files_.size() < kMost && std::getline(in, line);) {
        if (!line.empty()) {
            files_.emplace_back(line);
        }
    }
    look();
}

void RecentFiles::add(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    if (error || whole.string().find('\n') != std::string::npos) {
        return;
    }
    std::erase(files_, whole);
    files_.insert(files_.begin(), whole);
    files_.resize(std::min(files_.size(), kMost));
    look();
    write();
}

void RecentFiles::write() const {
    if (store_.empty()) {
        return;
    }
    std::error_code error;
    fs::create_directories(store_.parent_path(), error);
    std::string lines;
    for (const fs::path& file : files_) {
        lines += file.string() + '\n';
    }
    try {
        writeOutputFile(store_, lines);
    } catch (const OutputError&) {  // a convenience, see add()
    }
}

void RecentFiles::look() {
    there_.clear();
    std::ranges::copy_if(files_, std::back_inserter(there_), isThere);
}

std::vector<fs::path> RecentFiles::folders() const {
    std::vector<fs::path> folders;
    for (const fs::path& file : files()) {
        if (std::ranges::find(folders, file.parent_path()) == folders.end()) {
            folders.push_back(file.parent_path());
        }
    }
    return folders;
}

fs::path recentFilesStore() {
    return gpu::statePath("recent-files");
}

}  // namespace kerf::app
