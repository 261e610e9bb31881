#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "app/files/io/descriptor.h"
#include "app/files/io/errors.h"

namespace kerf::app {

/// For tests: before each call of the system by which a file is written, on whatever thread,
/// `fault` says with which errno it fails instead of being made; 0 for none. An empty function lets
/// all calls happen again.
void setFileFault(std::function<int()> fault);

/// A file that is being written. All files that Kerf writes go through the calls of this class.
class SystemFile {
  public:
    /// Opens `file` to be written, with `flags` of open(2) and the rights `mode`; what fails is
    /// told of `told`. Throws OutputError, as all functions here.
    SystemFile(const std::filesystem::path& file, int flags, unsigned mode,
               std::filesystem::path told);

    /// All of the bytes, or it throws.
    void write(std::string_view bytes);
    /// Waits until all that was written is on the disk.
    void sync();
    /// The same, but for times and the like, which nobody needs to read the content.
    void syncContent();
    void close();
    /// Gives the file of this name another one, in place of what is there.
    void rename(const std::filesystem::path& from, const std::filesystem::path& to);
    /// Whether no other process has it; it is ours then until it is closed.
    bool lock() { return lockFile(descriptor_.get()); }

    /// Takes the lock of an open file, unless another process, or another opening, has it.
    static bool lockFile(int descriptor);

  private:
    void require(bool succeeded) const;

    std::filesystem::path told_;
    Descriptor descriptor_;
};

/// Lets the names of a folder's files reach the disk. What fails is passed over: not all file
/// systems can do it, and the files are whole.
void syncFolder(const std::filesystem::path& folder);

}  // namespace kerf::app
