#pragma once

#include "app/files/import/own_looks.h"
#include "render/scene/appearance.h"
#include "render/scene/body_look.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

/// The looks of a body to write.
struct ExportLooks {
    OwnLooks own{};           ///< those of the model, transferred to the slots of the mesh
    render::BodyLook look{};  ///< used where it has none of its own
};

struct ExportFace {
    Triangle corners;                       ///< indices into ExportMesh::positions
    int piece = 0;                          ///< from 0
    bool cut = false;                       ///< made by a cut
    int material = 0;                       ///< index into ExportMesh::materials
    std::array<int, 3> uvs{-1, -1, -1};     ///< indices into ExportMesh::uvs; -1 for none
    std::array<int, 3> colors{-1, -1, -1};  ///< indices into ExportMesh::colors; -1 for none
    float strain = 0;                       ///< see largestStrain()
};

/// A mesh without dead slots and unused vertices, in float as it is written.
struct ExportMesh {
    std::vector<Vec3f> positions;         ///< counted from `origin`
    Vec3 origin = Vec3::Zero();           ///< see originOf()
    std::vector<Vec3> farPositions;       ///< absolute, if the origin is not 0
    std::vector<int> vertices;            ///< a number of each, in all parts of the mesh
    std::vector<Vec3f> normals;           ///< unit, area-weighted, one per position
    std::vector<Vec3f> velocities;        ///< one per position [1/s, in the unit of positions]
    std::vector<Eigen::Vector2f> uvs;     ///< each once, in the order of their first use
    std::vector<Eigen::Vector4f> colors;  ///< linear; each once, in the order of their first use
    std::vector<ExportFace> faces;
    /// Each with a unique name; "skin" is of faces without a material, "cut" of walls.
    std::vector<render::SurfaceMaterial> materials;
    std::shared_ptr<const render::Appearance> appearance;  ///< with the images; may be null
    std::vector<double> pieceVolumes;  ///< signed, by piece, in the unit of the positions
    /// Whether to write strains, velocities and volumes in all formats that can hold them.
    bool tellsQuantities = false;
    std::string coordinates = "metres, +y up";  ///< their description, for a comment in the file
};

/// The living triangles of `mesh`, whose positions are counted from `from`. Faces of cuts get the
/// material "cut" and texture coordinates in the plane of their cut, in the body's rest shape,
/// `unitsPerMetre` to a metre.
ExportMesh gatherMesh(const SurfaceMesh& mesh, const PieceMap& pieces, const ExportLooks& looks,
                      const Vec3& from = Vec3::Zero(), double unitsPerMetre = 1);

/// The colour of a corner of a face, in linear light, pictures aside. `withMaterials`: includes
/// materials.
Eigen::Vector4f cornerColor(const ExportMesh& mesh, const ExportFace& face, int corner,
                            bool withMaterials);
/// The colour of each position, in linear light: the mean over corners of the skin there, or of cut
/// faces if it touches no skin. `withMaterials`: includes materials.
std::vector<Eigen::Vector4f> vertexColors(const ExportMesh& mesh, bool withMaterials);

/// The faces for which `belongs(face)` is true, and what they use, in the same order.
template <class Belongs>
ExportMesh partOf(const ExportMesh& mesh, Belongs&& belongs) {
    ExportMesh part;
    part.origin = mesh.origin;
    part.coordinates = mesh.coordinates;
    part.pieceVolumes = mesh.pieceVolumes;
    part.tellsQuantities = mesh.tellsQuantities;
    part.materials = mesh.materials;
    part.appearance = mesh.appearance;
    std::vector<int> vertex(mesh.positions.size(), -1);
    std::vector<int> uv(mesh.uvs.size(), -1);
    std::vector<int> color(mesh.colors.size(), -1);
    const auto take = [](std::vector<int>& numbers, const auto& from, auto& into, int& index) {
        if (index >= 0 && numbers[index] < 0) {
            numbers[index] = static_cast<int>(into.size());
            into.push_back(from[index]);
        }
        index = index < 0 ? index : numbers[index];
    };
    for (const ExportFace& face : mesh.faces) {
        if (!belongs(face)) {
            continue;
        }
        ExportFace copy = face;
        for (int& v : copy.corners) {
            if (vertex[v] < 0) {
                part.vertices.push_back(mesh.vertices[v]);
                part.normals.push_back(mesh.normals[v]);
                part.velocities.push_back(mesh.velocities[v]);
                if (!mesh.farPositions.empty()) {
                    part.farPositions.push_back(mesh.farPositions[v]);
                }
            }
            take(vertex, mesh.positions, part.positions, v);
        }
        for (int i = 0; i < 3; ++i) {
            take(uv, mesh.uvs, part.uvs, copy.uvs[i]);
            take(color, mesh.colors, part.colors, copy.colors[i]);
        }
        part.faces.push_back(copy);
    }
    return part;
}

}  // namespace kerf::app
