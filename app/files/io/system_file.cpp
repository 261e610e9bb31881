#include "app/files/io/system_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>

#include "app/files/io/file_io.h"

namespace kerf::app {

namespace {

/// The fault of the tests, which any thread may ask for.
struct Fault {
    std::mutex mutex;
    std::function<int()> ask;
};

Fault& fault() {
    static Fault ours;
    return ours;
}

/// Whether the call may be made; otherwise errno says why not.
bool mayCall() {
    const std::lock_guard hold(fault().mutex);
    if (const int error = fault().ask ? fault().ask() : 0; error != 0) {
        errno = error;
        return false;
    }
    return true;
}

const char* adviceOn(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "free some space or choose another disk";
        case EROFS:
        case EACCES:
        case EPERM:
            return "choose a folder that you may write in";
        case ENOENT:
        case ENOTDIR:
            return "that folder doesn't exist or takes no files; choose another one";
        case ENAMETOOLONG:
            return "choose a shorter name";
        case EIO:
            return "the disk may be failing; choose another one";
        default:
            return "choose another name or folder";
    }
}

int opened(const std::filesystem::path& file, int flags, unsigned mode) {
    return mayCall() ? ::open(file.c_str(), flags | O_CLOEXEC, mode) : -1;
}

}  // namespace

bool Descriptor::close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
}

void holdStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF) {
            // It gets the lowest free number; to read what is to be written, or the other way,
            // fails as before.
            ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

std::array<int, 2> Pipe::open() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw OutputError(std::string("There is no pipe to another process (") +
                          std::strerror(errno) + ").");
    }
    return ends;
}

void setFileFault(std::function<int()> ask) {
    const std::lock_guard hold(fault().mutex);
    fault().ask = std::move(ask);
}

SystemFile::SystemFile(const std::filesystem::path& file, int flags, unsigned mode,
                       std::filesystem::path told)
    : told_(std::move(told)), descriptor_(opened(file, flags, mode)) {
    require(descriptor_.get() >= 0);
}

void SystemFile::require(bool succeeded) const {
    if (!succeeded) {
        const int error = errno;
        throw OutputError(told_.string() + ": it could not be written (" + std::strerror(error) +
                          "); " + adviceOn(error) + ".");
    }
}

void SystemFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written =
            mayCall() ? ::write(descriptor_.get(), bytes.data(), bytes.size()) : -1;
        require(written >= 0 || errno == EINTR);
        bytes.remove_prefix(written >= 0 ? static_cast<std::size_t>(written) : 0);
    }
}

void SystemFile::writeAtStart(std::string_view bytes) {
    const ssize_t written =
        mayCall() ? ::pwrite(descriptor_.get(), bytes.data(), bytes.size(), 0) : -1;
    require(written == static_cast<ssize_t>(bytes.size()));
}

void SystemFile::sync() {
    require(mayCall() && ::fsync(descriptor_.get()) == 0);
}

void SystemFile::close() {
    const bool may = mayCall();
    const int error = errno;
    const bool closed = descriptor_.close();
    errno = may ? errno : error;
    require(may && closed);
}

void SystemFile::rename(const std::filesystem::path& from, const std::filesystem::path& to) {
    require(mayCall() && ::rename(from.c_str(), to.c_str()) == 0);
}

void syncFolder(const std::filesystem::path& folder) {
    const std::filesystem::path& named = folder.empty() ? "." : folder;
    const Descriptor opened(::open(named.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.get() >= 0) {
        ::fsync(opened.get());
    }
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (::flock(folder_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        throw OutputError(shownPath(folder) +
                          ": another run writes its results there; wait until it has ended, or "
                          "choose another folder for --out.");
    }
}

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(std::max<ssize_t>(count, 0));
    }
    return true;
}

std::string readToEnd(int descriptor) {
    std::string bytes;
    std::array<char, 65536> block;
    for (;;) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0 || (count < 0 && errno != EINTR)) {
            return bytes;
        }
        bytes.append(block.data(), std::max<ssize_t>(count, 0));
    }
}

}  // namespace kerf::app
