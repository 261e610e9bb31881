#include "sim/cut/piece_groups.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "sim/mesh/union_find.h"

namespace kerf::cut {

namespace {

using PiecePair = std::pair<int, int>;

/// Of each two pieces with copies of one material point: the largest distance between such.
std::map<PiecePair, double> largestGaps(const SurfaceMesh& mesh, const std::vector<int>& piece,
                                        const std::vector<int>& before) {
    const auto together = [&](int a, int b) { return before.empty() || before[a] == before[b]; };
    std::map<PiecePair, double> gaps;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (piece[v] < 0 || mesh.mateGroup(v) < 0) {
            continue;
        }
        for (const int mate : mesh.matesOfGroup(mesh.mateGroup(v))) {
            if (mate > v && piece[mate] >= 0 && piece[mate] != piece[v]) {
                double& gap = gaps[std::minmax(piece[v], piece[mate])];
                gap = together(v, mate)
                          ? std::max(gap, (mesh.position(v) - mesh.position(mate)).norm())
                          : std::numeric_limits<double>::infinity();
            }
        }
    }
    return gaps;
}

}  // namespace

std::vector<int> groupPieces(const SurfaceMesh& mesh, const std::vector<int>& pieceOfVertex,
                             double tolerance, const std::vector<int>& before) {
    UnionFind groups(1 + *std::ranges::max_element(pieceOfVertex));
    for (const auto& [pair, gap] : largestGaps(mesh, pieceOfVertex, before)) {
        if (gap <= tolerance) {
            groups.join(pair.first, pair.second);
        }
    }
    std::vector<int> result;
    result.reserve(pieceOfVertex.size());
    for (const int piece : pieceOfVertex) {
        result.push_back(piece < 0 ? -1 : groups.root(piece));
    }
    return result;
}

}  // namespace kerf::cut
