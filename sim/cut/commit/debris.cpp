#include "sim/cut/commit/debris.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "sim/cut/cut_change.h"

namespace kerf::cut {

namespace {

int largestPiece(const PieceLabels& pieces) {
    const auto largest = std::ranges::max_element(
        pieces.pieces(), {}, [](const PieceContent& p) { return p.restVolume; });
    return static_cast<int>(largest - pieces.pieces().begin());
}

/// Ascending.
std::vector<int> trianglesOf(const SurfaceMesh& mesh, const PieceLabels& pieces,
                             const std::vector<int>& which, int firstTriangle) {
    std::set<int> found;
    std::vector<int> open;
    const auto add = [&](int t) {
        if (found.insert(t).second) {
            open.push_back(t);
        }
    };
    for (int t = firstTriangle; t < mesh.triangleSlots(); ++t) {
        if (mesh.alive(t) &&
            std::ranges::binary_search(which, pieces.ofVertex()[mesh.triangle(t)[0]])) {
            add(t);
        }
    }
    while (!open.empty()) {
        const int t = open.back();
        open.pop_back();
        for (int corner = 0; corner < 3; ++corner) {
            add(mesh.twin(3 * t + corner) / 3);
        }
    }
    return {found.begin(), found.end()};
}

std::vector<int> cornersOf(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    std::set<int> corners;
    for (const int t : triangles) {
        corners.insert(mesh.triangle(t).begin(), mesh.triangle(t).end());
    }
    return {corners.begin(), corners.end()};
}

}  // namespace

std::vector<int> findDebris(const SurfaceMesh& mesh, const PieceLabels& pieces, int firstTriangle,
                            double leastVolume) {
    const int largest = largestPiece(pieces);
    std::set<int> found;
    for (int t = firstTriangle; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t) || mesh.kind(t) != SurfaceKind::wall) {
            continue;
        }
        const int piece = pieces.ofVertex()[mesh.triangle(t)[0]];
        if (piece != largest && std::fabs(pieces.pieces()[piece].restVolume) < leastVolume) {
            found.insert(piece);
        }
    }
    return {found.begin(), found.end()};
}

std::vector<int> removePieces(SurfaceMesh& mesh, const PieceLabels& pieces,
                              const std::vector<int>& which, int firstTriangle, CutDelta& delta) {
    // A cavity may lie in what comes off without having been cut.
    std::vector<int> triangles =
        trianglesOf(mesh, pieces, which, pieces.hasCavities() ? 0 : firstTriangle);
    const std::vector<int> vertices = cornersOf(mesh, triangles);
    for (const int t : triangles) {
        mesh.removeTriangle(t);
    }
    for (const int v : vertices) {
        mesh.removeVertex(v);
    }
    noteRemoved(triangles, vertices, delta);
    return triangles;
}

}  // namespace kerf::cut
