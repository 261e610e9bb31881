#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "app/files/io/descriptor.h"
#include "app/files/io/errors.h"

namespace kerf::app {

/// For tests: before each system call for writing a file, on any thread, `fault` returns the errno
/// with which it fails; 0 for none. An empty function restores all calls.
void setFileFault(std::function<int()> fault);

/// A file that is being written. Kerf writes all files through this class.
class SystemFile {
  public:
    /// Opens `file` for writing, with `flags` of open(2) and permissions `mode`; errors name
    /// `told`. Throws OutputError, like all functions here.
    SystemFile(const std::filesystem::path& file, int flags, unsigned mode,
               std::filesystem::path told);

    /// Writes all bytes, or throws.
    void write(std::string_view bytes);
    /// Waits until all that was written is on the disk.
    void sync();
    /// sync() without metadata that reading does not need, such as times.
    void syncContent();
    void close();
    /// Renames a file, replacing what is there.
    void rename(const std::filesystem::path& from, const std::filesystem::path& to);
    /// Locks it until it is closed; false if another process has the lock.
    bool lock() { return lockFile(descriptor_.get()); }

    /// Takes the lock of an open file, unless another process, or another opening, has it.
    static bool lockFile(int descriptor);

  private:
    void require(bool succeeded) const;

    std::filesystem::path told_;
    Descriptor descriptor_;
};

/// Syncs the names of a folder's files to disk. Failures are ignored: not all file systems support
/// it, and the files are complete.
void syncFolder(const std::filesystem::path& folder);

}  // namespace kerf::app
