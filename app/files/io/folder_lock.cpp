#include "app/files/io/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

#include "app/files/io/file_io.h"

namespace kerf::app {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (::flock(folder_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        throw OutputError(shownPath(folder) +
                          ": another run writes its results there; wait until it has ended, or "
                          "choose another folder for --out.");
    }
}

}  // namespace kerf::app
