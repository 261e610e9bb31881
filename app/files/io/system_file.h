#pragma once

#include "app/files/io/errors.h"

namespace kerf::app {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    /// Its number; -1 once closed.
    int get() const { return number_; }
    /// Whether all written data reached the system; true if closed already.
    bool close();

  private:
    int number_;
};

/// Opens unusable files as 0, 1 and 2 if a program starts without them: otherwise the next opened
/// file would get one, and with it standard output or error.
void holdStandardStreams();

/// A pipe to a child. Both ends are closed on exec, unless duplicated.
struct Pipe {
    /// Throws OutputError if there are too many open files.
    static std::array<int, 2> open();
    explicit Pipe(std::array<int, 2> ends = open()) : read(ends[0]), write(ends[1]) {}
    Descriptor read;
    Descriptor write;
};

/// Writes all bytes to a pipe or stream; false if that fails.
bool writeAll(int descriptor, std::string_view bytes);
/// Reads a pipe to its end, or as far as it can be read.
std::string readToEnd(int descriptor);

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
    /// Replaces the first bytes, without moving where write() goes on.
    void writeAtStart(std::string_view bytes);
    /// Waits until all that was written is on the disk.
    void sync();
    void close();
    /// Renames a file, replacing what is there.
    void rename(const std::filesystem::path& from, const std::filesystem::path& to);

  private:
    void require(bool succeeded) const;

    std::filesystem::path told_;
    Descriptor descriptor_;
};

/// Syncs the names of a folder's files to disk. Failures are ignored: not all file systems support
/// it, and the files are complete.
void syncFolder(const std::filesystem::path& folder);

/// A lock on a folder, so that only one of several programs of Kerf on a machine writes there at a
/// time. The system releases it when its holder ends; children don't inherit it, and no file is
/// made. On file systems without locks it does nothing.
class FolderLock {
  public:
    /// Throws OutputError if another one holds the folder, which must exist.
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    Descriptor folder_;
};

}  // namespace kerf::app
