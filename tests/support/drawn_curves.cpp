#include "tests/support/drawn_curves.h"

#include <tuple>

namespace kerf::test {

int DrawnCurves::add(cut::CutNode node, const Triangle& corners, const Vec3& weights) {
    for (int i = 0; i < 3; ++i) {
        node.position += weights[i] * mesh_.position(corners[i]);
        node.rest += weights[i] * mesh_.restPosition(corners[i]);
        node.velocity += weights[i] * mesh_.velocity(corners[i]);
    }
    curves.nodes.push_back(node);
    return cut::sizeOf(curves.nodes) - 1;
}

int DrawnCurves::onEdge(int u, int v, double t, int strip) {
    cut::CutNode node;
    node.kind = cut::NodeKind::edge;
    std::tie(node.a, node.b) = cut::edgeOf(u, v);
    node.t = node.a == u ? t : 1 - t;
    const int id = add(node, {node.a, node.b, node.b}, {1 - node.t, node.t, 0});
    std::vector<cut::EdgeHit>& hits = curves.onEdge[cut::edgeOf(u, v)];
    hits.push_back({strip, id});
    std::ranges::sort(hits, {}, [&](const cut::EdgeHit& hit) { return curves.nodes[hit.node].t; });
    const int h = mesh_.findHalfEdge(u, v);
    curves.segmentsOfTriangle[h / 3];
    curves.segmentsOfTriangle[mesh_.twin(h) / 3];
    return id;
}

int DrawnCurves::inFace(int triangle, const Vec3& weights, int strip) {
    cut::CutNode node;
    node.kind = cut::NodeKind::face;
    node.a = triangle;
    node.weights = weights;
    node.stripEdge = strip;
    const int id = add(node, mesh_.triangle(triangle), weights);
    curves.onFace[{triangle, strip}] = id;
    curves.segmentsOfTriangle[triangle];
    return id;
}

int DrawnCurves::atVertex(int v) {
    return curves.vertexNode(mesh_, v, Vec2::Zero());
}

void DrawnCurves::segment(int triangle, int from, int to, int strip) {
    curves.segmentsOfTriangle[triangle].push_back(cut::sizeOf(curves.segments));
    curves.segments.push_back({triangle, strip, from, to});
}

}  // namespace kerf::test
