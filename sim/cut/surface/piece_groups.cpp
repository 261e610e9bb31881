#include "sim/cut/surface/piece_groups.h"

#include "sim/mesh/union_find.h"

namespace kerf::cut {

namespace {

using PiecePair = std::pair<int, int>;

/// Whether all copies that two pieces have of the same vertices lie together, by the pair; for
/// pieces of one group.
std::map<PiecePair, bool> contacts(const SurfaceMesh& mesh, const std::vector<int>& piece,
                                   const std::vector<int>& group, double tolerance) {
    std::map<PiecePair, bool> together;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (piece[v] < 0 || mesh.copyGroup(v) < 0) {
            continue;
        }
        for (const int copy : mesh.copiesOfGroup(mesh.copyGroup(v))) {
            if (copy > v && piece[copy] >= 0 && piece[copy] != piece[v] &&
                group[piece[copy]] == group[piece[v]]) {
                bool& lie =
                    together.try_emplace(std::minmax(piece[v], piece[copy]), true).first->second;
                lie = lie && (mesh.position(v) - mesh.position(copy)).norm() <= tolerance;
            }
        }
    }
    return together;
}

bool anyShared(std::vector<int> group) {
    std::sort(group.begin(), group.end());
    return std::adjacent_find(group.begin(), group.end()) != group.end();
}

}  // namespace

std::vector<int> groupPieces(const SurfaceMesh& mesh, const PieceLabels& pieces, double tolerance,
                             const std::vector<int>& before) {
    const std::size_t count = pieces.pieces().size();
    const std::vector<int> group = before.empty() ? std::vector<int>(count, 0) : before;
    UnionFind groups(count);
    if (anyShared(group)) {
        for (const auto& [pair, lie] : contacts(mesh, pieces.ofVertex(), group, tolerance)) {
            if (lie) {
                groups.join(pair.first, pair.second);
            }
        }
    }
    std::vector<int> result(count);
    for (std::size_t p = 0; p < count; ++p) {
        result[p] = groups.root(static_cast<int>(p));
    }
    return result;
}

void GroupedPieces::group(double tolerance) {
    groupOfPiece_ = groupPieces(mesh_, labels_, tolerance, {});
    hold_ = true;
}

std::optional<std::vector<int>> GroupedPieces::divide(double tolerance) {
    if (std::exchange(hold_, true)) {
        return std::nullopt;
    }
    return std::exchange(groupOfPiece_, groupPieces(mesh_, labels_, tolerance, groupOfPiece_));
}

void GroupedPieces::update(std::span<const int> changed, int groupOfNewPieces) {
    hold_ = false;
    const std::vector<int> source = labels_.update(mesh_, changed).source;
    const std::vector<int> before = std::exchange(groupOfPiece_, {});
    for (const int piece : source) {
        groupOfPiece_.push_back(piece < 0 ? groupOfNewPieces : before[piece]);
    }
}

int GroupedPieces::groupOf(int vertex) const {
    const int piece = labels_.ofVertex()[vertex];
    return piece < 0 ? -1 : groupOfPiece_[piece];
}

std::vector<int> GroupedPieces::lowestVertices(std::set<int> numbers) const {
    std::vector<int> found;
    for (int v = 0; v < mesh_.vertexCount() && !numbers.empty(); ++v) {
        if (numbers.erase(groupOf(v)) > 0) {
            found.push_back(v);
        }
    }
    return found;
}

}  // namespace kerf::cut
