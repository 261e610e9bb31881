#pragma once

#include "sim/mesh/invariants.h"

namespace kerf::test {

/// Half-edges of present triangles beside absent ones, ascending: the border of the open surface.
inline std::vector<int> borderHalfEdges(const SurfaceMesh& mesh) {
    std::vector<int> border;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.present(h / 3) && mesh.absent(mesh.twin(h) / 3)) {
            border.push_back(h);
        }
    }
    return border;
}

/// checkClosedManifold() with an open stroke: the mesh with its absent walls is a closed
/// 2-manifold, what is present one with a border along them, which passes each vertex once at most.
inline std::string checkOpenManifold(const SurfaceMesh& mesh) {
    std::vector<int> passes(mesh.vertexCount(), 0);
    for (const int h : borderHalfEdges(mesh)) {
        if (++passes[mesh.origin(h)] > 1) {
            return "the border of the open surface passes a vertex twice";
        }
    }
    return checkClosedManifold(mesh);
}

}  // namespace kerf::test
