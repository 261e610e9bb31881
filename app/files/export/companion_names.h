#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace kerf::app {

/// Chooses the names of files that stand beside an export and that it refers to: materials,
/// buffers, images. Nobody was asked about these, so nothing that somebody else made is replaced.
class CompanionNames {
  public:
    /// They will lie in this folder.
    explicit CompanionNames(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// `wanted`, made safe as a name in a folder and in a URI; or that with a number where a file
    /// of the name is neither the same nor an earlier one of Kerf.
    std::string nameFor(const std::string& wanted, std::string_view bytes) const;
    /// Whether that very file is there already.
    bool isThere(const std::string& name, std::string_view bytes) const;

  private:
    bool mayBecome(const std::string& name, std::string_view bytes) const;

    std::filesystem::path folder_;
};

/// The bytes that begin a companion of Kerf, by which nameFor() knows it.
inline constexpr std::string_view kCompanionMark = "Kerf";

}  // namespace kerf::app
