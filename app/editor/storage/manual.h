#pragma once

#include <filesystem>
#include <string>

namespace kerf::app {

/// The first page of the documentation: the installed one, else that of the source tree.
std::filesystem::path manualPage();

/// Opens a file with the program that the desktop has for it, by xdg-open. Returns a sentence for
/// the user. Throws OutputError if that fails within a few seconds.
std::string openOutside(const std::filesystem::path& file);

}  // namespace kerf::app
