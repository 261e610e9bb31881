#include "sim/cut/plan/bridges.h"

#include <map>

#include "sim/mesh/union_find.h"

namespace kerf::cut {

namespace {

/// What a connected part of the border of the new walls meets.
struct Reach {
    bool start = false;      ///< behind the old front
    bool front = false;      ///< where the new walls end
    std::set<int> oldWalls;  ///< by label
    /// The material beside the start is parted from all that lies ahead.
    bool endsAtOldWall() const { return !front && oldWalls.size() == 1; }
};

bool liesOnOldRung(const OutlineEdge& edge, const std::vector<CutNode>& nodes) {
    return edge.kind == OutlineKind::free && nodes[edge.from].layout.y() == 0 &&
           nodes[edge.to].layout.y() == 0;
}

}  // namespace

std::set<int> piecesOfFront(const std::vector<RungNode>& rung,
                            const std::vector<int>& pieceOfVertex) {
    std::set<int> pieces;
    for (const RungNode& node : rung) {
        if (node.attached) {
            pieces.insert(pieceOfVertex[node.vertex]);
        }
    }
    return pieces;
}

bool leavesBridge(const SurfaceMesh& mesh, int stroke, const std::set<int>& pieces,
                  const StepPlan& plan) {
    const std::vector<CutNode>& nodes = plan.curves.nodes;
    UnionFind parts(nodes.size());
    for (const OutlineEdge& edge : plan.outline.edges) {
        parts.join(edge.from, edge.to);
    }
    std::map<int, Reach> reached;
    for (const FrontPoint& point : plan.outline.front) {
        reached[parts.root(point.node)].front |= point.attached;
    }
    for (const OutlineEdge& edge : plan.outline.edges) {
        if (pieces.contains(edge.piece) && liesOnOldRung(edge, nodes)) {
            reached[parts.root(edge.from)].start = true;
        }
    }
    for (const Segment& segment : plan.curves.segments) {
        const int label = mesh.wallLabel(segment.triangle);
        if (label >= 0 && label / 2 == stroke) {
            reached[parts.root(segment.from)].oldWalls.insert(label);
        }
    }
    std::set<int> sides;
    for (const auto& [root, reach] : reached) {
        if (reach.start && !reach.endsAtOldWall()) {
            return true;
        }
        if (reach.start) {
            sides.insert(*reach.oldWalls.begin());
        }
    }
    return sides.size() > 1;
}

}  // namespace kerf::cut
