#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/files/io/file_stamp.h"

namespace kerf::app {

/// Watches the model files of the open scene for changes by other programs. Each change is told
/// once.
class ModelWatch {
  public:
    /// Begins with the files of another scene. A file that is watched already may have changed
    /// while the scene was read, which the next look finds.
    void begin(const std::vector<std::filesystem::path>& files);
    /// Looks at the files. A change counts once a file is the same at two looks, since it may still
    /// be being written. Returns whether one counts now.
    bool look();
    /// The files whose change is offered.
    const std::vector<std::filesystem::path>& changed() const { return changed_; }
    /// Drops the offer.
    void ignore() { changed_.clear(); }

  private:
    struct Watched {
        std::filesystem::path file;
        std::optional<FileStamp> known;
        std::optional<FileStamp> seen;  ///< at the last look
    };
    std::vector<Watched> files_;
    std::vector<std::filesystem::path> changed_;
};

}  // namespace kerf::app
