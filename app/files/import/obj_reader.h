#pragma once

#include <filesystem>

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads an OBJ file: faces of any number of corners, counted from the start or backwards;
/// colours behind vertices, 0 to 1 or 0 to 255; texture coordinates; materials of .mtl files in its
/// folder and below. Points, lines, normals and groups are left out; what is not known is named in
/// a remark. Throws InputError for what is no number, and for a corner that is not there.
ImportedModel readObj(const std::filesystem::path& file);

}  // namespace kerf::app
