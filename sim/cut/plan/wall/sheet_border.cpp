#include "sim/cut/plan/wall/sheet_border.h"

namespace kerf::cut {

namespace {

constexpr double kCoincident = 1e-11;  // share of h

std::vector<OutlineEdge> allEdges(const Sheet2d& sheet) {
    std::vector<OutlineEdge> edges = sheet.outer;
    for (const Loop& hole : sheet.holes) {
        edges.insert(edges.end(), hole.begin(), hole.end());
    }
    return edges;
}

Layout2d boundsOf(const std::vector<OutlineEdge>& edges, const std::vector<CutNode>& nodes) {
    Layout2d box;
    for (const OutlineEdge& edge : edges) {
        box.low = box.low.cwiseMin(nodes[edge.from].layout);
        box.high = box.high.cwiseMax(nodes[edge.from].layout);
    }
    return box;
}

Triangulation planeAround(const Layout2d& box) {
    const double size = (box.high - box.low).maxCoeff() + 1e-9;
    const Vec2 center = 0.5 * (box.low + box.high);
    return {center + Vec2(-20, -15) * size, center + Vec2(20, -15) * size,
            center + Vec2(0, 25) * size};
}

}  // namespace

BorderedSheet::BorderedSheet(const Sheet2d& sheet, const std::vector<CutNode>& nodes,
                             int firstInner, double h)
    : nodes_(nodes),
      edges_(allEdges(sheet)),
      bounds_(boundsOf(edges_, nodes)),
      firstInner_(firstInner),
      plane_(planeAround(bounds_)) {
    insertBorder(kCoincident * h);
    constrainBorder();
    markInside();
}

const CutNode* BorderedSheet::borderNode(int vertex) const {
    return vertex < 3 || vertex >= borderVertices_ ? nullptr : &nodes_[nodeOfVertex_[vertex]];
}

void BorderedSheet::addInner(const Vec2& layout, const Vec3& position,
                             const Triangulation::Location& at) {
    CutNode& node = inner_.emplace_back();
    node.layout = layout;
    node.position = position;
    plane_.insert(layout, at);
    nodeOfVertex_.push_back(firstInner_ + sizeOf(inner_) - 1);
}

// Coincident border nodes share a vertex of the triangulation; each corner later takes the
// node of the border edge that bounds its wedge.
void BorderedSheet::insertBorder(double coincident) {
    plane_.reserve(edges_.size());
    vertexOfNode_.assign(nodes_.size(), -1);
    nodeOfVertex_.assign(3, -1);
    for (const int node : nodesAlongBlade()) {
        const Vec2& p = nodes_[node].layout;
        const Triangulation::Location at = plane_.locate(p);
        if (at.triangle < 0) {
            throw StepFailure{"a wall node lies outside the layout"};
        }
        int vertex = cornerNear(at.triangle, p, coincident);
        if (vertex < 0) {
            vertex = plane_.insert(p, at).vertex;
        }
        vertexOfNode_[node] = vertex;
        if (vertex == sizeOf(nodeOfVertex_)) {
            nodeOfVertex_.push_back(node);
        }
    }
    borderVertices_ = sizeOf(nodeOfVertex_);
}

/// Of the border, each once, from B to A: each new one lies beside the last, so that few edges
/// flip. Along one side of a strip and then the other it would be twice as many. At one place
/// of the blade those behind come first: rectangles get the same diagonals as around the
/// border.
std::vector<int> BorderedSheet::nodesAlongBlade() const {
    struct BorderPoint {
        double x, y;
        int node;
    };
    std::vector<BorderPoint> points;
    points.reserve(edges_.size());
    for (const OutlineEdge& edge : edges_) {
        const Vec2& at = nodes_[edge.from].layout;
        points.push_back({at.x(), at.y(), edge.from});
    }
    std::ranges::sort(points, [](const BorderPoint& p, const BorderPoint& q) {
        return p.x != q.x ? p.x > q.x : p.y != q.y ? p.y < q.y : p.node < q.node;
    });
    std::vector<int> order;
    order.reserve(points.size());
    for (const BorderPoint& point : points) {
        if (order.empty() || order.back() != point.node) {
            order.push_back(point.node);
        }
    }
    return order;
}

/// The corner of a triangle that lies within a distance of p along both axes, -1 for none.
int BorderedSheet::cornerNear(int t, const Vec2& p, double distance) const {
    const Triangle& corners = plane_.corners(t);
    const auto near = std::ranges::find_if(
        corners, [&](int v) { return (plane_.point(v) - p).cwiseAbs().maxCoeff() < distance; });
    return near == corners.end() ? -1 : *near;
}

void BorderedSheet::constrainBorder() {
    border_ = DirectedEdges(borderVertices_);
    border_.reserve(edges_.size());
    edgesFrom_.assign(borderVertices_, 0);
    for (int i = 0; i < sizeOf(edges_); ++i) {
        const int a = vertexOfNode_[edges_[i].from];
        const int b = vertexOfNode_[edges_[i].to];
        if (a == b || !border_.add(a, b, i) || !plane_.constrain(a, b)) {
            throw StepFailure{"the border of the wall crosses itself"};
        }
        ++edgesFrom_[a];
    }
}

bool BorderedSheet::isBorder(int t, int e) const {
    const Triangle& c = plane_.corners(t);
    return border_.has(c[e], c[(e + 1) % 3]);
}

void BorderedSheet::markInside() {
    std::vector<int> pending;
    for (int t = 0; t < plane_.size(); ++t) {
        plane_.setMarked(t, false);
        for (int e = 0; e < 3; ++e) {
            if (plane_.constrained(t, e) && isBorder(t, e) && !plane_.marked(t)) {
                plane_.setMarked(t, true);
                pending.push_back(t);
            }
        }
    }
    while (!pending.empty()) {
        const int t = pending.back();
        pending.pop_back();
        for (int e = 0; e < 3; ++e) {
            spreadMark(t, e, pending);
        }
    }
}

void BorderedSheet::spreadMark(int t, int e, std::vector<int>& pending) {
    if (plane_.constrained(t, e)) {
        if (!isBorder(t, e)) {
            throw StepFailure{"inside and outside of the wall conflict"};
        }
        return;
    }
    const int other = plane_.neighbor(t, e);
    if (other < 0) {
        throw StepFailure{"the wall is unbounded"};
    }
    if (!plane_.marked(other)) {
        plane_.setMarked(other, true);
        pending.push_back(other);
    }
}

std::vector<Triangle> BorderedSheet::triangles() const {
    std::vector<Triangle> result;
    result.reserve(plane_.size());
    for (int t = 0; t < plane_.size(); ++t) {
        if (plane_.marked(t)) {
            result.push_back(nodesOf(t));
        }
    }
    return result;
}

// Where several border edges start at one vertex, turns clockwise about the corner to its own.
int BorderedSheet::nodeOfCorner(int t, int corner) const {
    const int v = plane_.corners(t)[corner];
    if (v >= borderVertices_ || edgesFrom_[v] == 1) {
        return nodeOfVertex_[v];
    }
    int current = t;
    do {
        int k = 0;
        while (plane_.corners(current)[k] != v) {
            ++k;
        }
        if (plane_.constrained(current, k)) {
            const int edge = border_.find(v, plane_.corners(current)[(k + 1) % 3]);
            if (edge < 0) {
                break;
            }
            return edges_[edge].from;
        }
        current = plane_.neighbor(current, k);
    } while (current >= 0 && current != t);
    throw StepFailure{"a wall corner has no border edge"};
}

}  // namespace kerf::cut
