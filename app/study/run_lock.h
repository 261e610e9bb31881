#pragma once

#include "app/files/io/system_file.h"

namespace kerf::app {

/// A lock on one run of a study, so that only one of several programs that share its folder, on one
/// or more machines, runs it at a time. The system releases it when its holder ends. On a file
/// system without locks it does nothing.
class RunLock {
  public:
    /// Waits until the run is free. The lock is a hidden file of `out`, which must exist. Throws
    /// OutputError if that can't be opened.
    RunLock(const std::filesystem::path& out, std::size_t number);
    ~RunLock();
    /// Throws OutputError if that file can't be opened.
    static void requireFile(const std::filesystem::path& out);
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

  private:
    Descriptor file_;
    std::size_t number_;
};

}  // namespace kerf::app
