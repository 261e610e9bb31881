#pragma once

#include "app/files/jobs/background_job.h"

namespace kerf::app {

/// A few lines about a model or a session: what it is, how large, how many triangles.
std::vector<std::string> describeFile(const std::filesystem::path& file, WorkProgress& progress);

/// The lines of describeFile() about the selected file, found on a separate thread. Deselected
/// files are dropped.
class FilePreview {
  public:
    /// Selects another file; an empty path shows nothing.
    void select(const std::filesystem::path& file);
    /// Whether the lines have changed since the last call; call it once a frame.
    bool advance();
    const std::vector<std::string>& lines() const { return lines_; }
    bool working() const { return job_.now() != nullptr; }

  private:
    using Job = BackgroundJob<std::vector<std::string>>;

    std::filesystem::path file_;
    std::vector<std::string> lines_;
    bool changed_ = false;
    CurrentJob<Job> job_;
};

}  // namespace kerf::app
