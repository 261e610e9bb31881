#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/mesh_formats.h"
#include "sim/base/placement.h"
#include "sim/mesh/corner_uvs.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The living triangles at their current positions and the vertices that they use, as the bytes of
/// a file. `pieces` must be those of `mesh`; `uvs` its texture coordinates by slot (see carryUvs),
/// or empty. Pieces and the faces of cuts can be told apart:
/// - ply: binary little-endian; x y z nx ny nz per vertex, `piece` (int) and `cut` (uchar, 1 on the
///   faces that a cut made) per face; vertices are shared inside a piece. Texture coordinates
///   stand with the faces (`texcoord`, empty on the faces of cuts).
/// - obj: an object per piece with the groups `skin` and `cut`.
/// - stl: binary; the attribute word of a triangle is its piece; without texture coordinates.
/// - glb, gltf: glTF 2.0, a node and a mesh per piece with a primitive for each of the materials
///   `skin` and `cut`; in a .gltf the buffer is part of the file.
std::string encodeMesh(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format,
                       const std::vector<CornerUvs>& uvs = {});

/// The coordinates that a mesh is written in.
enum class Coordinates {
    model,  ///< those of the model's own file: its unit, axes and place
    scene,  ///< metres, +y up, as the body lies in the scene
};
/// In the order of the enumerators.
inline constexpr std::string_view kCoordinatesNames[] = {"model", "scene"};

/// The file, or the files, that a body is exported to; its extension names the format.
struct ExportTarget {
    std::filesystem::path file;
    bool filePerPiece = false;  ///< named by pieceFile()
    Coordinates coordinates = Coordinates::scene;
};
struct ExportedFile {
    std::filesystem::path file;
    std::string bytes;
};
/// encodeMesh() of the whole body or of each piece. `placement` is how the numbers of the model's
/// file became the metres of `mesh`; what has not moved at all has exactly its own again.
std::vector<ExportedFile> encodeExport(const ExportTarget& target, const SurfaceMesh& mesh,
                                       const PieceMap& pieces, const std::vector<CornerUvs>& uvs,
                                       const Placement& placement = {});

/// The file of a piece where each piece gets one: "slice.obj" becomes "slice-1.obj" for piece 0.
std::filesystem::path pieceFile(const std::filesystem::path& file, int piece);

}  // namespace kerf::app
