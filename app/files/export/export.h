#pragma once

#include "app/files/export/export_mesh.h"
#include "app/files/export/mesh_formats.h"
#include "sim/base/placement.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The living triangles at their current positions and the vertices that they use, as the bytes of
/// a file that stands alone. `pieces` must be those of `mesh`; the skin of `looks` is by slot of it
/// (see carrySkin). Pieces and the faces of cuts can be told apart:
/// - ply: binary little-endian; x y z nx ny nz per vertex, `piece` (int) and `cut` (uchar, 1 on the
///   faces that a cut made) per face; vertices are shared inside a piece. Texture coordinates
///   stand with the faces (`texcoord`, empty on the faces of cuts). No colours.
/// - obj: an object per piece with the groups `skin` and `cut`; no materials.
/// - stl: binary; the attribute word of a triangle is its piece; no looks at all.
/// - glb, gltf: glTF 2.0, a node and a mesh per piece with a primitive per material, and all images
///   in the file.
/// - vtp: VTK XML PolyData with the arrays `piece`, `cut`, `strain` and `piece_volume` of the
/// cells,
///   `Normals` and `velocity` of the points; no looks at all.
/// Positions are counted from `from`. Far from the origin ply, obj and vtp hold doubles, and nodes
/// of glTF are moved there; stl rounds to floats.
std::string encodeMesh(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format,
                       const ExportLooks& looks = {}, const Vec3& from = Vec3::Zero());
/// encodeMesh() with strain, velocity and volume in further formats: ply as `vx vy vz` of a vertex
/// and `strain` and `piece_volume` of a face, glb and gltf as attributes `_VELOCITY` and `_STRAIN`,
/// and the volume as an extra of a node.
std::string encodeMeasured(const SurfaceMesh& mesh, const PieceMap& pieces, MeshFormat format,
                           const ExportLooks& looks = {}, const Vec3& from = Vec3::Zero());

/// The file, or the files, that a body is exported to; its extension names the format.
struct ExportTarget {
    std::filesystem::path file;
    bool filePerPiece = false;  ///< named by pieceFile()
    Coordinates coordinates = Coordinates::scene;
    /// The folder of a relative `file`.
    std::filesystem::path folder{};
    /// A triangle of the only piece to be exported, instead of all.
    std::optional<int> pieceAt{};
};
struct ExportedFile {
    std::filesystem::path file;
    std::string bytes;
};
/// The place of a body: the placement of its model, and the origin of its positions in the scene.
struct ExportFrame {
    Placement placement{};
    Vec3 origin = Vec3::Zero();
};
/// encodeMesh() of the whole body or of each piece, then the missing files that they refer to: an
/// .mtl and images beside an .obj, a .bin and images beside a .gltf, the image beside a .ply that
/// has one. A .ply has the colours of its vertices (see vertexColors). Vertices that have not moved
/// from their `place` keep their exact numbers.
std::vector<ExportedFile> encodeExport(const ExportTarget& target, const SurfaceMesh& mesh,
                                       const PieceMap& pieces, const ExportLooks& looks,
                                       const ExportFrame& place = {});

/// The looks of an uncut body, transferred to the cut body.
OwnLooks carried(const OwnLooks& looks, const SurfaceMesh& uncut, const SurfaceMesh& cut);

/// The file of a single piece: "slice.obj" becomes "slice-1.obj" for piece 0.
std::filesystem::path pieceFile(const std::filesystem::path& file, int piece);
/// Whether a path is that of some piece, by its name.
bool isPieceFile(const std::filesystem::path& path, const std::filesystem::path& file);

}  // namespace kerf::app
