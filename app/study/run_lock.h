#pragma once

#include <filesystem>

#include "app/files/io/descriptor.h"

namespace kerf::app {

/// Holds one run of a study, so that of several programs that share its folder, on one machine or
/// on several, only one runs it at a time. The system lets go of it when its holder ends, however
/// that ends. On a file system without locks it holds nothing.
class RunLock {
  public:
    /// Waits until nobody else holds the run. The lock lies in a hidden file of `out`, which must
    /// be there. Throws OutputError where that can't be opened.
    RunLock(const std::filesystem::path& out, std::size_t number);
    ~RunLock();
    /// Throws OutputError where that file can't be opened.
    static void requireFile(const std::filesystem::path& out);
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;

  private:
    Descriptor file_;
    std::size_t number_;
};

}  // namespace kerf::app
