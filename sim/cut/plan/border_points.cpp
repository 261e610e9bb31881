#include "sim/cut/plan/border_points.h"

#include <algorithm>
#include <utility>

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

}  // namespace kerf::cut
