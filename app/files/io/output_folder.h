#pragma once

namespace kerf::app {

/// The output folder of a run, and the files written. Nothing is written or removed outside it,
/// whatever the names and links.
class OutputFolder {
  public:
    /// Makes the folder if missing. Throws OutputError, like all functions here.
    explicit OutputFolder(const std::filesystem::path& folder);
    /// Removes the folders that were made here and are still empty.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Path of the file `name`, whose folder is made. Throws also if the name or a link leads
    /// outside.
    std::filesystem::path pathOf(const std::string& name);
    /// Removes what an interrupted run has left of the file `name`, which nobody else may be
    /// writing.
    void removeUnfinished(const std::string& name) const;
    /// Removes an earlier result, if there is one; of a link, the link.
    void remove(const std::string& name) const;
    /// Writes a whole file; it appears complete or not at all.
    void write(const std::string& name, std::string_view bytes);
    /// Records a file that others wrote at its pathOf().
    void noteWritten(const std::string& name) { written_.push_back(name); }
    /// Names of the files in the order of writing.
    const std::vector<std::string>& written() const { return written_; }

  private:
    void makeFolders(const std::filesystem::path& folder);
    std::filesystem::path insidePath(const std::string& name) const;

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> made_;  ///< folders, outer ones first
    std::vector<std::string> written_;
};

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
