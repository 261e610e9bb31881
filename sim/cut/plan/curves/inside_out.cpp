#include "sim/cut/plan/curves/inside_out.h"

namespace kerf::cut {

namespace {

class BorderWalk {
  public:
    BorderWalk(const StepInput& in, const Strip& strip, int piece, const CutCurves& curves,
               const std::vector<Segment>& segments)
        : in_(in), strip_(strip), piece_(piece), curves_(curves) {
        countCurveEnds(segments);
        collectFaceNodes();
    }

    std::vector<BorderPoint> run() {
        const std::vector<int> edgeFrom = borderEdges();
        const auto first = std::ranges::find_if(edgeFrom, [](int edge) { return edge >= 0; });
        const int start = static_cast<int>(first - edgeFrom.begin());
        points_.reserve(edgeFrom.size());
        int v = start;
        do {
            const int edge = edgeFrom[v];
            if (edge < 0 || points_.size() > 1000000) {
                throw StepFailure{"the border of the strip is open"};
            }
            addNode(v);
            points_.back().link = Link::stripEdge;
            points_.back().edge = edge;
            for (const int node : faceNodesOfEdge_[edge]) {
                points_.push_back(
                    {node, -1, -1, events_[node], Link::stripEdge, edge, curves_.nodes[node].u});
            }
            v = strip_.edges[edge].b;
        } while (v != start);
        return std::move(points_);
    }

  private:
    // The body is entered where a curve ends on the border, and left where one starts.
    void countCurveEnds(const std::vector<Segment>& segments) {
        events_.assign(curves_.nodes.size(), 0);
        for (const Segment& segment : segments) {
            --events_[segment.from];
            ++events_[segment.to];
        }
    }

    void collectFaceNodes() {
        faceNodesOfEdge_.resize(strip_.edges.size());
        for (const auto& [key, node] : curves_.onFace) {
            const auto [triangle, edge] = key;
            if (strip_.edges[edge].onBorder &&
                in_.pieceOfVertex[in_.mesh.triangle(triangle)[0]] == piece_) {
                faceNodesOfEdge_[edge].push_back(node);
            }
        }
        for (std::vector<int>& nodes : faceNodesOfEdge_) {
            std::ranges::sort(nodes, {}, [&](int p) { return std::pair(curves_.nodes[p].u, p); });
        }
    }

    /// By strip node: the border edge that starts there, -1 where none does.
    std::vector<int> borderEdges() const {
        std::vector<int> edgeFrom(strip_.nodes.size(), -1);
        for (int e = 0; e < sizeOf(strip_.edges); ++e) {
            if (strip_.edges[e].onBorder && std::exchange(edgeFrom[strip_.edges[e].a], e) >= 0) {
                throw StepFailure{"the strip is pinched"};
            }
        }
        return edgeFrom;
    }

    /// At least one point.
    void addNode(int v) {
        const StripNode& strip = strip_.nodes[v];
        const std::size_t before = points_.size();
        for (int i = 0; i < sizeOf(strip.vertices); ++i) {
            const int vertex = strip.vertices[i];
            const int node = curves_.nodeOfVertex.find(vertex);
            const int event = node < 0 ? 0 : events_[node];
            // Several front vertices at one place, joined by front edges of length zero.
            const bool held = strip.joinsNext(i) || strip.joinsNext(i - 1);
            if (held || event != 0) {
                points_.push_back(
                    {node, vertex, v, event, strip.joinsNext(i) ? Link::zeroFront : Link::none});
            }
        }
        if (points_.size() == before) {
            const int vertex = strip.vertices.size() == 1 ? strip.vertices.front() : -1;
            points_.push_back({-1, vertex, v});
        }
    }

    const StepInput& in_;
    const Strip& strip_;
    int piece_;
    const CutCurves& curves_;
    std::vector<int> events_;  ///< by node
    std::vector<std::vector<int>> faceNodesOfEdge_;
    std::vector<BorderPoint> points_;
};

// Two curve ends in impossible order are swapped when closer than this share of h: coincident or
// slightly inter-penetrating walls of an older slit.
constexpr double kTieDistance = 0.25;

/// Goes round the points and counts how often the body has been entered.
class InsideOut {
  public:
    InsideOut(const StepInput& in, const Strip& strip, std::vector<BorderPoint>& points)
        : in_(in), strip_(strip), points_(points) {}

    void run() {
        const auto hasEvent = [](const BorderPoint& p) { return p.event != 0; };
        const auto isOnFront = [this](const BorderPoint& p) { return p.isOnFront(strip_); };
        if (std::ranges::any_of(points_, [](auto& p) { return std::abs(p.event) > 1; })) {
            throw StepFailure{"two curves end at one point of the blade's border"};
        }
        if (std::ranges::any_of(points_, hasEvent)) {
            countWindings();
        } else {
            const bool inside = std::ranges::any_of(points_, isOnFront);
            std::ranges::for_each(points_, [&](BorderPoint& p) { p.inside = inside; });
        }
        for (const BorderPoint& point : points_) {
            if (isOnFront(point) && !point.inside) {
                throw StepFailure{"the front lies outside"};
            }
            if (point.inside && isInTheAir(point)) {
                throw StepFailure{"the air lies inside"};
            }
        }
    }

  private:
    /// A node of the blade far away from the body.
    bool isInTheAir(const BorderPoint& point) const {
        if (point.stripNode < 0 || in_.body.empty()) {
            return false;
        }
        const StripNode& node = strip_.nodes[point.stripNode];
        return node.vertices.empty() && !in_.body.overlaps({node.position, node.position});
    }

    /// A point of which it is known that nothing is inside there, -1 for none.
    int pointInTheAir() const {
        const auto found =
            std::ranges::find_if(points_, [this](auto& point) { return isInTheAir(point); });
        return found == points_.end() ? -1 : static_cast<int>(found - points_.begin());
    }

    /// The point behind the lowest sum of events.
    int lowestPoint() const {
        int lowest = 0;
        int sum = 0;
        int first = 0;
        for (int i = 0; i < sizeOf(points_); ++i) {
            sum += points_[i].event;
            if (sum < lowest) {
                lowest = sum;
                first = (i + 1) % sizeOf(points_);
            }
        }
        return first;
    }

    /// 0, unless the front says otherwise.
    int windingBefore(int first) const {
        int winding = 0;
        for (int k = 0; k < sizeOf(points_); ++k) {
            const BorderPoint& point = points_[(first + k) % sizeOf(points_)];
            winding += point.event;
            if (point.isOnFront(strip_) && winding < 1) {
                return 1;
            }
        }
        return 0;
    }

    void countWindings() {
        const int n = sizeOf(points_);
        const int inAir = pointInTheAir();
        const int first = inAir >= 0 ? inAir : lowestPoint();
        int winding = inAir >= 0 ? 0 : windingBefore(first);
        for (int k = 0; k < n; ++k) {
            const int i = (first + k) % n;
            if (k + 1 < n) {
                swapIfImpossible(points_[i], points_[(i + 1) % n], winding);
            }
            winding += points_[i].event;
            if (winding < 0 || winding > 1) {
                throw StepFailure{"the blade's border enters the body twice"};
            }
            points_[i].inside = winding == 1;
        }
    }

    void swapIfImpossible(BorderPoint& here, BorderPoint& next, int winding) const {
        const bool between = here.stripNode < 0 && next.stripNode < 0 && here.edge == next.edge;
        const bool impossible =
            (winding == 1 && here.event == 1) || (winding == 0 && here.event == -1);
        if (!between || !impossible || next.event != -here.event) {
            return;
        }
        const StripEdge& edge = strip_.edges[here.edge];
        const double length =
            (strip_.nodes[edge.a].position - strip_.nodes[edge.b].position).norm();
        if (std::fabs(next.u - here.u) * length < kTieDistance * in_.h) {
            std::swap(here, next);
        }
    }

    const StepInput& in_;
    const Strip& strip_;
    std::vector<BorderPoint>& points_;
};

}  // namespace

double BorderPoint::parameter(const Strip& strip) const {
    if (stripNode >= 0) {
        return strip.nodes[stripNode].s;
    }
    const double from = strip.nodes[strip.edges[edge].a].s;
    return from + (strip.nodes[strip.edges[edge].b].s - from) * u;
}

std::set<int> piecesInStrip(const StepInput& in, const Strip& strip, const CutCurves& curves) {
    std::set<int> pieces;
    for (const Segment& segment : curves.segments) {
        pieces.insert(in.pieceOfVertex[in.mesh.triangle(segment.triangle)[0]]);
    }
    for (const StripNode& node : strip.nodes) {
        for (const int v : node.vertices) {
            pieces.insert(in.pieceOfVertex[v]);
        }
    }
    return pieces;
}

std::vector<BorderPoint> borderPoints(const StepInput& in, const Strip& strip, int piece,
                                      const CutCurves& curves,
                                      const std::vector<Segment>& segments) {
    return BorderWalk(in, strip, piece, curves, segments).run();
}

std::vector<BorderPoint> tellInsideOut(const StepInput& in, const Strip& strip,
                                       std::vector<BorderPoint> points) {
    InsideOut(in, strip, points).run();
    return points;
}

}  // namespace kerf::cut
