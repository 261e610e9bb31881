#pragma once

#include <filesystem>

#include "app/files/io/descriptor.h"

namespace kerf::app {

/// Holds a folder, so that of several programs of Kerf on one machine only one at a time writes its
/// results there. The system lets go of it when its holder ends, however that ends; children don't
/// inherit it, and nothing lies in the folder. Where the file system has no locks it holds nothing.
class FolderLock {
  public:
    /// Throws OutputError where another one holds the folder, which must be there.
    explicit FolderLock(const std::filesystem::path& folder);

  private:
    Descriptor folder_;
};

}  // namespace kerf::app
