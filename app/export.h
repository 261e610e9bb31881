#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// Formats that a mesh can be written in.
enum class MeshFormat { ply, obj, stl };
/// By the file's extension (.ply, .obj, .stl); none for any other.
std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& file);

/// The living triangles at their current positions and the vertices that they use, as the bytes of
/// a file. `pieces` must be those of `mesh`. Pieces and the faces of cuts can be told apart:
/// - ply: binary little-endian; x y z nx ny nz per vertex, `piece` (int) and `cut` (uchar, 1 on the
///   faces that a cut made) per face; vertices are shared inside a piece.
/// - obj: an object per piece with the groups `skin` and `cut`.
/// - stl: binary; the attribute word of a triangle is its piece.
std::string encodeMesh(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format);

}  // namespace kerf::app
