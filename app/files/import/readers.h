#pragma once

#include <filesystem>

#include "app/files/import/import_protocol.h"

namespace kerf::app {

/// Reads an OBJ file: faces of any number of corners, counted from the start or backwards;
/// colours behind vertices, 0 to 1 or 0 to 255; texture coordinates; materials of .mtl files in its
/// folder and below. Points, lines, normals and groups are left out; what is not known is named in
/// a remark. Throws InputError for what is no number, and for a corner that is not there.
ImportedModel readObj(const std::filesystem::path& file);

/// Reads an OFF file of text, with faces of any number of corners, and colours of vertices or faces
/// where it has them. Throws InputError for what is no number, for a binary file, for other than
/// three dimensions, and where there is less in the file than it says.
ImportedModel readOff(const std::filesystem::path& file);

/// Reads a PLY file: text or binary, of any byte order, line end and order of elements; faces of
/// any number of corners and triangle strips; colours of vertices or faces, texture coordinates of
/// vertices or corners, and the image that a comment TextureFile names. Throws InputError where
/// there is less in the file than its header says.
ImportedModel readPly(const std::filesystem::path& file);

/// Reads an STL file: binary, with its facets' colours where it has some, also where bytes stand
/// behind the last facet; or text in letters of either kind, with comments and blank lines. Normals
/// are those of the facets, whatever the file says. Throws InputError where it ends too early, and
/// for a corner that is no number.
ImportedModel readStl(const std::filesystem::path& file);

/// Reads a glTF 2.0 or GLB file as its scene shows it at rest: nodes where they stand, skins by
/// their joints, morph targets by their weights, numbers quantized or sparse, colours, materials
/// and the first texture of each. Points and lines are left out. Throws InputError for what is
/// broken, and by its name for an extension that changes the shape and is not read.
ImportedModel readGltf(const std::filesystem::path& file);

}  // namespace kerf::app
