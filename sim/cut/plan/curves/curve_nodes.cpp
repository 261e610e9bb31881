#include "sim/cut/plan/curves/curve_nodes.h"

#include <algorithm>
#include <utility>

namespace kerf::cut {

namespace {

// Curve nodes keep this distance (as parameter or weight) from the ends of their edge and the
// border of their triangle, so that positions of neighbours in one edge stay distinct.
constexpr double kLeastParameter = 1e-9;
// A point that lies no farther outside of a triangle, as a weight, is on its border; and one no
// farther from the end of an edge, as a share, is at that end.
constexpr double kBeside = 1e-3;

}  // namespace

CurveNodes::CurveNodes(const StepInput& in, const Strip& strip, const PredicatePositions& positions)
    : mesh_(in.mesh), strip_(strip), positions_(positions) {
    curves_.nodes.reserve(2 * strip.nodes.size());
}

int CurveNodes::add(const CutNode& node) {
    curves_.nodes.push_back(node);
    return sizeOf(curves_.nodes) - 1;
}

/// What is seen beside the strip, but lies in it, is met where it lies.
double CurveNodes::parameterOf(int from, int to, double t) const {
    if (positions_.isAside(from) && t < kBeside) {
        return 0;
    }
    return positions_.isAside(to) && t > 1 - kBeside ? 1 : t;
}

int CurveNodes::onEdge(const TrianglePair& pair, const Crossing& crossing) {
    const int from = pair.mesh.ids[crossing.from];
    const int to = pair.mesh.ids[crossing.to];
    std::vector<EdgeHit>& hits = curves_.onEdge[edgeOf(from, to)];
    const auto known = std::ranges::find(hits, pair.strip.index, &EdgeHit::stripTriangle);
    if (known != hits.end()) {
        return known->node;
    }
    CutNode node;
    node.kind = NodeKind::edge;
    node.a = from;
    node.b = to;
    node.t = parameterOf(from, to, crossing.t);
    for (int i = 0; i < 3; ++i) {
        node.layout += crossing.weights[i] * strip_.nodes[pair.strip.ids[i]].layout;
    }
    hits.push_back({pair.strip.index, add(node)});
    return hits.back().node;
}

/// In canonical order; of a triangle with a corner that is seen beside the strip, where it lies.
Vec3 CurveNodes::weightsInStrip(const TrianglePair& pair, const Crossing& crossing) const {
    const Triangle& ids = pair.mesh.ids;
    if (std::ranges::any_of(ids, [&](int v) { return positions_.isAside(v); })) {
        Corners at;
        for (int i = 0; i < 3; ++i) {
            at[i] = positions_.inStrip(ids[pair.mesh.order[i]]);
        }
        const Vec3 weights =
            weightsOfCrossing(pair.strip.at[crossing.from], pair.strip.at[crossing.to], at);
        if (weights.allFinite() && weights.minCoeff() > -kBeside) {
            return weights.cwiseMax(0.0) / weights.cwiseMax(0.0).sum();
        }
    }
    return crossing.weights;
}

int CurveNodes::onFace(const TrianglePair& pair, int m, int edge, const Crossing& crossing) {
    const auto [known, isNew] = curves_.onFace.try_emplace({m, edge}, sizeOf(curves_.nodes));
    if (!isNew) {
        return known->second;
    }
    CutNode node;
    node.kind = NodeKind::face;
    node.a = m;
    node.stripEdge = edge;
    const Vec3 weights = weightsInStrip(pair, crossing);
    for (int i = 0; i < 3; ++i) {
        node.weights[pair.mesh.order[i]] = weights[i];
    }
    const int from = pair.strip.ids[crossing.from];
    const Vec2& start = strip_.nodes[from].layout;
    const Vec2& end = strip_.nodes[pair.strip.ids[crossing.to]].layout;
    node.layout = start + (end - start) * crossing.t;
    node.u = strip_.edges[edge].a == from ? crossing.t : 1 - crossing.t;
    return add(node);
}

int CurveNodes::atSharedVertex(const TrianglePair& pair) {
    const StripNode& corner = strip_.nodes[pair.strip.ids[pair.shared.stripCorner]];
    return curves_.vertexNode(mesh_, pair.shared.vertex, corner.layout);
}

void CurveNodes::join(int m, int stripTriangle, int from, int to) {
    curves_.segmentsOfTriangle[m].push_back(sizeOf(curves_.segments));
    curves_.segments.push_back({m, stripTriangle, from, to});
}

CutCurves CurveNodes::take() {
    for (auto& [edge, hits] : curves_.onEdge) {
        orderAlongEdge(hits);
    }
    // Positions come from the real edges and triangles, also where predicates saw them elsewhere.
    for (CutNode& node : curves_.nodes) {
        if (node.kind == NodeKind::edge) {
            placeOnEdge(node);
        } else if (node.kind == NodeKind::face) {
            placeOnFace(node);
        }
    }
    return std::move(curves_);
}

void CurveNodes::orderAlongEdge(std::vector<EdgeHit>& hits) {
    std::vector<CutNode>& nodes = curves_.nodes;
    std::sort(hits.begin(), hits.end(), [&](const EdgeHit& p, const EdgeHit& q) {
        return nodes[p.node].t != nodes[q.node].t ? nodes[p.node].t < nodes[q.node].t
                                                  : p.stripTriangle < q.stripTriangle;
    });
    const int n = sizeOf(hits);
    const double gap = std::min(kLeastParameter, 0.5 / (n + 1));
    for (int i = 0; i < n; ++i) {
        double& t = nodes[hits[i].node].t;
        const double low = std::max(gap * (i + 1), i > 0 ? nodes[hits[i - 1].node].t + gap : 0.0);
        t = std::min(1 - gap * (n - i), std::max(t, low));
    }
}

void CurveNodes::placeOnEdge(CutNode& node) const {
    const auto lerp = [&](const Vec3& p, const Vec3& q) { return Vec3(p + (q - p) * node.t); };
    node.position = lerp(mesh_.position(node.a), mesh_.position(node.b));
    node.rest = lerp(mesh_.restPosition(node.a), mesh_.restPosition(node.b));
    node.velocity = lerp(mesh_.velocity(node.a), mesh_.velocity(node.b));
}

// In canonical order throughout: the mirrored node in the other wall of an older slit comes out the
// same to the last bit, or the Delaunay criterion would divide the two walls differently.
void CurveNodes::placeOnFace(CutNode& node) const {
    const Triangle& ids = mesh_.triangle(node.a);
    SeenTriangle seen(ids, {positions_.at(ids[0]), positions_.at(ids[1]), positions_.at(ids[2])});
    seen.putInOrder();
    const std::array<int, 3>& order = seen.order;
    node.weights = node.weights.cwiseMax(kLeastParameter);
    node.weights /= node.weights[order[0]] + node.weights[order[1]] + node.weights[order[2]];
    for (const int i : order) {
        node.position += node.weights[i] * mesh_.position(ids[i]);
        node.rest += node.weights[i] * mesh_.restPosition(ids[i]);
        node.velocity += node.weights[i] * mesh_.velocity(ids[i]);
    }
}

}  // namespace kerf::cut
