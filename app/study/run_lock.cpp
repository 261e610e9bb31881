#include "app/study/run_lock.h"

#include <fcntl.h>

#include <cerrno>
#include <cstring>

#include "app/files/io/file_io.h"

namespace kerf::app {

namespace {

constexpr const char* kLockFile = ".lock";

/// Children inherit it: the run stays held until the last one that may write has ended.
int openLockFile(const std::filesystem::path& file) {
    const int opened = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW, 0666);
    if (opened < 0) {
        throw OutputError(file.string() + ": this file can't be written (" + std::strerror(errno) +
                          ").");
    }
    return opened;
}

/// A byte of the file for each run.
struct flock byteOf(std::size_t number, short type) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = static_cast<off_t>(number);
    lock.l_len = 1;
    return lock;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& out, std::size_t number)
    : file_(openLockFile(out / kLockFile)), number_(number) {
    struct flock lock = byteOf(number, F_WRLCK);
    while (::fcntl(file_.get(), F_OFD_SETLKW, &lock) < 0 && errno == EINTR) {
    }
}

void RunLock::requireFile(const std::filesystem::path& out) {
    const Descriptor file(openLockFile(out / kLockFile));
}

RunLock::~RunLock() {
    struct flock lock = byteOf(number_, F_UNLCK);
    ::fcntl(file_.get(), F_OFD_SETLK, &lock);
}

}  // namespace kerf::app
