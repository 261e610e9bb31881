#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/mesh/corner_uvs.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/surface_mesh.h"

namespace kerf::app {

struct ExportFace {
    Triangle corners;                    ///< indices into ExportMesh::positions
    int piece = 0;                       ///< from 0
    bool cut = false;                    ///< made by a cut
    std::array<int, 3> uvs{-1, -1, -1};  ///< indices into ExportMesh::uvs; -1 for none
};

/// A mesh without dead slots and unused vertices, in float as it is written.
struct ExportMesh {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;        ///< unit, area-weighted, one per position
    std::vector<Eigen::Vector2f> uvs;  ///< each once, in the order of their first use
    std::vector<ExportFace> faces;
    std::string coordinates = "metres, +y up";  ///< what they are, for a comment in the file
};

/// The living triangles of `mesh`. `uvs`: by slot, or empty; walls get none.
ExportMesh gatherMesh(const SurfaceMesh& mesh, const PieceMap& pieces,
                      const std::vector<CornerUvs>& uvs);

/// The faces for which `belongs(face)` holds, and what they use, in the same order.
template <class Belongs>
ExportMesh partOf(const ExportMesh& mesh, Belongs&& belongs) {
    ExportMesh part;
    part.coordinates = mesh.coordinates;
    std::vector<int> vertex(mesh.positions.size(), -1);
    std::vector<int> uv(mesh.uvs.size(), -1);
    for (const ExportFace& face : mesh.faces) {
        if (!belongs(face)) {
            continue;
        }
        ExportFace copy = face;
        for (int& v : copy.corners) {
            if (vertex[v] < 0) {
                vertex[v] = static_cast<int>(part.positions.size());
                part.positions.push_back(mesh.positions[v]);
                part.normals.push_back(mesh.normals[v]);
            }
            v = vertex[v];
        }
        for (int& u : copy.uvs) {
            if (u >= 0 && uv[u] < 0) {
                uv[u] = static_cast<int>(part.uvs.size());
                part.uvs.push_back(mesh.uvs[u]);
            }
            u = u < 0 ? u : uv[u];
        }
        part.faces.push_back(copy);
    }
    return part;
}

}  // namespace kerf::app
