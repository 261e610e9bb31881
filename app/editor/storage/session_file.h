#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/files/io/file_stamp.h"
#include "app/scene/document/stored_ends.h"

namespace kerf::app {

/// The session file of the open scene, which saving writes again.
class SessionFile {
  public:
    const StoredEnds ends;  ///< of the sessions that were saved

    explicit SessionFile(StoredEnds stored) : ends(std::move(stored)) {}

    /// Begins with the file that was opened; empty for none, as for the sessions of Kerf's own.
    void begin(const std::filesystem::path& file);
    /// Records that this window has written the file.
    void noteWritten(const std::filesystem::path& file);
    const std::filesystem::path& path() const { return path_; }
    /// Why it should not be replaced without a question: one sentence, or "".
    std::string doubt() const;

  private:
    std::filesystem::path path_;
    std::optional<FileStamp> stamp_;  ///< when it was opened or written
    bool ours_ = false;               ///< written by this window
};

}  // namespace kerf::app
