#pragma once

#include <filesystem>

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads a PLY file: text or binary, of any byte order, line end and order of elements; faces of
/// any number of corners and triangle strips; colours of vertices or faces, texture coordinates of
/// vertices or corners, and the image that a comment TextureFile names. Throws InputError where
/// there is less in the file than its header says.
ImportedModel readPly(const std::filesystem::path& file);

}  // namespace kerf::app
