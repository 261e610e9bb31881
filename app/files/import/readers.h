#pragma once

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads an OBJ file: faces of any number of corners, counted from the start or backwards; colours
/// behind vertices, 0 to 1 or 0 to 255; texture coordinates; materials of .mtl files in its folder
/// and below. Points, lines, normals and groups are skipped; unknown statements become a remark.
/// Throws InputError for invalid numbers and missing corners.
ImportedModel readObj(const std::filesystem::path& file);

/// Reads a text OFF file, with faces of any number of corners, and colours of vertices or faces if
/// present. Throws InputError for invalid numbers, a binary file, other than three dimensions, and
/// a truncated file.
ImportedModel readOff(const std::filesystem::path& file);

/// Reads a PLY file: text or binary, of any byte order, line end and order of elements; faces of
/// any number of corners and triangle strips; colours of vertices or faces, texture coordinates of
/// vertices or corners, and the image of a comment TextureFile. Throws InputError if the file is
/// shorter than its header says.
ImportedModel readPly(const std::filesystem::path& file);

/// Reads an STL file: binary, with facet colours if present, also with bytes after the last facet;
/// or text in upper or lower case, with comments and blank lines. Normals are computed from the
/// facets. Throws InputError for a truncated file and invalid numbers.
ImportedModel readStl(const std::filesystem::path& file);

/// Reads the scene of a glTF 2.0 or GLB file at rest: placed nodes, skins by their joints, morph
/// targets by their weights, quantized or sparse numbers, colours, materials and the first texture
/// of each. Points and lines are skipped. Throws InputError for broken files, and for an
/// unsupported extension that changes the shape.
ImportedModel readGltf(const std::filesystem::path& file);

}  // namespace kerf::app
