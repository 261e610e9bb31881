#pragma once

#include <string>
#include <vector>

#include "sim/mesh/invariants.h"

namespace kerf::test {

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
