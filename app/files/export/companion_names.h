#pragma once

namespace kerf::app {

/// Chooses the names of files beside an export that it refers to: materials, buffers, images. Since
/// the user did not name these, files of others are not replaced.
class CompanionNames {
  public:
    /// For files in this folder.
    explicit CompanionNames(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// `wanted`, made safe for file names and URIs; with a number if a file of the name is neither
    /// equal nor Kerf's.
    std::string nameFor(const std::string& wanted, std::string_view bytes) const;
    /// Whether that file exists with these bytes.
    bool isThere(const std::string& name, std::string_view bytes) const;

  private:
    bool mayBecome(const std::string& name, std::string_view bytes) const;

    std::filesystem::path folder_;
};

/// The first bytes of Kerf's companions, by which nameFor() recognizes them.
inline constexpr std::string_view kCompanionMark = "Kerf";

}  // namespace kerf::app
