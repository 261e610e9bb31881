#pragma once

namespace kerf::test {

/// An empty folder of its own, gone with everything in it at the end of the scope.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

void writeText(const std::filesystem::path& file, std::string_view text);
/// All bytes of a file; empty where there is none.
std::string readBytes(const std::filesystem::path& file);

}  // namespace kerf::test
