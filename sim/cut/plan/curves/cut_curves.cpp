#include "sim/cut/plan/curves/cut_curves.h"

#include "sim/cut/wall_copies.h"

namespace kerf::cut {

CutNode nodeAtVertex(const SurfaceMesh& mesh, int v, const Vec2& layout) {
    CutNode node;
    node.kind = NodeKind::vertex;
    node.a = v;
    node.layout = layout;
    node.position = mesh.position(v);
    node.rest = mesh.restPosition(v);
    node.velocity = mesh.velocity(v);
    return node;
}

std::vector<PointKey> pointKeys(const SurfaceMesh& mesh, const CutCurves& curves) {
    std::vector<PointKey> keys(curves.nodes.size(), {-1, -1, -1, -1});
    for (const auto& [edge, hits] : curves.onEdge) {
        const Edge points = edgeOf(mesh.firstCopy(edge.first), mesh.firstCopy(edge.second));
        for (const EdgeHit& hit : hits) {
            keys[hit.node] = {points.first, points.second, -1, hit.stripTriangle};
        }
    }
    for (const auto& [place, node] : curves.onFace) {
        const auto [a, b, c] = pointsOf(mesh, place.first);
        keys[node] = {a, b, c, place.second};
    }
    return keys;
}

int CutCurves::vertexNode(const SurfaceMesh& mesh, int v, const Vec2& layout) {
    if (const int known = nodeOfVertex.find(v); known >= 0) {
        return known;
    }
    append({nodeAtVertex(mesh, v, layout)});
    return sizeOf(nodes) - 1;
}

void CutCurves::append(const std::vector<CutNode>& more) {
    for (const CutNode& node : more) {
        if (node.kind == NodeKind::vertex) {
            nodeOfVertex.add(node.a, sizeOf(nodes));
        }
        nodes.push_back(node);
    }
}

}  // namespace kerf::cut
