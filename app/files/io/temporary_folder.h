#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// A new temporary folder, removed with its content at the end of the scope.
class TemporaryFolder {
  public:
    /// Its name begins with `name`. Throws OutputError if none can be made.
    explicit TemporaryFolder(const std::string& name);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace kerf::app
