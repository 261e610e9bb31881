#pragma once

#include <filesystem>

#include "app/files/io/descriptor.h"

namespace kerf::app {

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
