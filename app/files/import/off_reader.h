#pragma once

#include <filesystem>

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads an OFF file of text, with faces of any number of corners, and colours of vertices or faces
/// where it has them. Throws InputError for what is no number, for a binary file, for other than
/// three dimensions, and where there is less in the file than it says.
ImportedModel readOff(const std::filesystem::path& file);

}  // namespace kerf::app
