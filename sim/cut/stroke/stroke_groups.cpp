// Which pieces are cut together, and the rungs of all groups.

#include <algorithm>
#include <map>
#include <utility>

#include "sim/cut/plan/step.h"
#include "sim/cut/stroke/cutter_state.h"
#include "sim/cut/surface/piece_groups.h"

namespace kerf {

using cut::GroupStroke;

/// The lowest vertex of each of these groups; ascending. O(n), where there is one.
std::vector<int> Cutter::State::lowestVertices(std::set<int> numbers) const {
    std::vector<int> found;
    for (int v = 0; v < mesh.vertexCount() && !numbers.empty(); ++v) {
        if (numbers.erase(groupOfVertex(v)) > 0) {
            found.push_back(v);
        }
    }
    return found;
}

int Cutter::State::groupOfVertex(int v) const {
    const int piece = pieces.ofVertex()[v];
    return piece < 0 ? -1 : groupOfPiece[piece];
}

// Pieces that have parted since go on apart, each with its own part of the rung. A piece that has
// gone (debris) takes its group along.
void Cutter::State::divideGroups() {
    if (std::exchange(groupsHold, true)) {
        return;
    }
    const std::vector<int> before =
        std::exchange(groupOfPiece, cut::groupPieces(mesh, pieces, kParted * h, groupOfPiece));
    std::map<int, int> placeOfNumber;  // in `groups`, by the number before
    std::set<int> parted(groupOfPiece.begin(), groupOfPiece.end());
    for (int i = 0; i < cut::sizeOf(groups); ++i) {
        placeOfNumber[groups[i].number] = i;
        groups[i].number = groupOfVertex(groups[i].vertex);
        parted.erase(groups[i].number);
    }
    std::set<int> divided;
    for (const int v : lowestVertices(std::move(parted))) {
        const int parent = placeOfNumber.at(before[pieces.ofVertex()[v]]);
        GroupStroke part = groups[parent];
        part.vertex = v;
        part.number = groupOfVertex(v);
        groups.push_back(std::move(part));
        keepOwnNodes(groups[parent].rung, groups.back());
        divided.insert(parent);
    }
    for (const int parent : divided) {
        keepOwnNodes(groups[parent].rung, groups[parent]);
    }
    std::erase_if(groups, [](const GroupStroke& group) { return group.number < 0; });
}

void Cutter::State::keepOwnNodes(std::vector<RungNode> nodes, GroupStroke& group) {
    std::erase_if(nodes, [&](const RungNode& node) {
        return node.vertex >= 0 && groupOfVertex(node.vertex) != group.number;
    });
    if (nodes.size() < 2) {
        // All of the front is in other pieces, both ends too: for this one the blade begins here.
        placeRung(group.blade, group);
        return;
    }
    setRung(std::move(nodes), group);
}

void Cutter::State::joinRungs() {
    rung.clear();
    for (const GroupStroke& group : groups) {
        rung.insert(rung.end(), group.rung.begin(), group.rung.end());
    }
}

// The skin beside the air of any rung may have changed.
void Cutter::State::tieRungs() {
    for (GroupStroke& group : groups) {
        tie(group);
    }
}

void Cutter::State::holdLivingVertices() {
    for (GroupStroke& group : groups) {
        if (mesh.outgoing(group.vertex) < 0) {
            const std::vector<int> living = lowestVertices({group.number});
            group.vertex = living.empty() ? group.vertex : living.front();
        }
    }
}

}  // namespace kerf
