#include "app/editor/storage/session_file.h"

#include "app/editor/storage/file_chooser.h"

namespace kerf::app {

void SessionFile::begin(const std::filesystem::path& file) {
    path_ = isOurs(file) ? std::filesystem::path() : file;
    stamp_ = stampOf(path_);
    ours_ = false;
}

void SessionFile::noteWritten(const std::filesystem::path& file) {
    path_ = file;
    stamp_ = stampOf(file);
    ours_ = true;
}

std::string SessionFile::doubt() const {
    const std::optional<FileStamp> now = stampOf(path_);
    if (!now || (ours_ && now == stamp_)) {
        return "";
    }
    const std::string name = path_.filename().string();
    return now == stamp_ ? name + " is the session that you opened. Saving replaces it."
                         : name + " was changed by another program. Saving replaces that version.";
}

}  // namespace kerf::app
