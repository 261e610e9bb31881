// Which pieces are swept together, and the rungs of all groups.

#include <algorithm>
#include <map>
#include <utility>

#include "sim/cut/plan/step.h"
#include "sim/cut/stroke/cutter_state.h"
#include "sim/cut/surface/piece_groups.h"

namespace kerf {

using cut::Sweep;

/// Of each of these groups; ascending. O(n), where there is one.
std::vector<int> Cutter::State::lowestVertices(std::set<int> groups) const {
    std::vector<int> found;
    for (int v = 0; v < mesh.vertexCount() && !groups.empty(); ++v) {
        if (groups.erase(groupOfVertex(v)) > 0) {
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
// gone (debris) takes its sweep along.
void Cutter::State::divideSweeps() {
    if (std::exchange(groupsHold, true)) {
        return;
    }
    const std::vector<int> before =
        std::exchange(groupOfPiece, cut::groupPieces(mesh, pieces, kParted * h, groupOfPiece));
    std::map<int, int> sweepOfGroupBefore;
    std::set<int> parted(groupOfPiece.begin(), groupOfPiece.end());
    for (int i = 0; i < cut::sizeOf(sweeps); ++i) {
        sweepOfGroupBefore[sweeps[i].group] = i;
        sweeps[i].group = groupOfVertex(sweeps[i].vertex);
        parted.erase(sweeps[i].group);
    }
    std::set<int> divided;
    for (const int v : lowestVertices(std::move(parted))) {
        const int parent = sweepOfGroupBefore.at(before[pieces.ofVertex()[v]]);
        Sweep part = sweeps[parent];
        part.vertex = v;
        part.group = groupOfVertex(v);
        sweeps.push_back(std::move(part));
        keepOwnNodes(sweeps[parent].rung, sweeps.back());
        divided.insert(parent);
    }
    for (const int parent : divided) {
        keepOwnNodes(sweeps[parent].rung, sweeps[parent]);
    }
    std::erase_if(sweeps, [](const Sweep& sweep) { return sweep.group < 0; });
}

void Cutter::State::keepOwnNodes(std::vector<RungNode> nodes, Sweep& sweep) {
    std::erase_if(nodes, [&](const RungNode& node) {
        return node.vertex >= 0 && groupOfVertex(node.vertex) != sweep.group;
    });
    if (nodes.size() < 2) {
        // All of the front is in other pieces, both ends too: for this one the blade begins here.
        placeRung(sweep.blade, sweep);
        return;
    }
    setRung(std::move(nodes), sweep);
}

void Cutter::State::joinRungs() {
    rung.clear();
    for (const Sweep& sweep : sweeps) {
        rung.insert(rung.end(), sweep.rung.begin(), sweep.rung.end());
    }
}

// The skin beside the air of any rung may have changed.
void Cutter::State::tieRungs() {
    for (Sweep& sweep : sweeps) {
        tie(sweep);
    }
}

void Cutter::State::holdLivingVertices() {
    for (Sweep& sweep : sweeps) {
        if (mesh.outgoing(sweep.vertex) < 0) {
            const std::vector<int> living = lowestVertices({sweep.group});
            sweep.vertex = living.empty() ? sweep.vertex : living.front();
        }
    }
}

}  // namespace kerf
