#include "sim/cut/plan/outline.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace kerf::cut {

namespace {

// Two curve ends in impossible order are swapped when closer than this share of h: coincident or
// slightly inter-penetrating walls of an older slit.
constexpr double kTieDistance = 0.25;

/// What leads from one point of the border to the next.
enum class Link {
    stripEdge,   ///< a piece of a strip edge
    none,        ///< nothing: both points are one strip node, seen from two sides of a gap
    zeroFront,   ///< a front edge of length zero inside a cluster
    touchedEdge  ///< the mesh edge from a front end to a vertex that touches it
};

/// A point on the border of the strip.
struct BorderPoint {
    int node = -1;       ///< -1: a strip node without a curve node yet
    int stripNode = -1;  ///< -1: between two strip nodes
    int event = 0;       ///< +1: the body is entered here, -1: left
    Link link = Link::stripEdge;
    int edge = -1;  ///< strip edge that follows, for Link::stripEdge
    double u = 0;
    bool inside = false;  ///< of the piece that follows
};

/// The walk of one piece of the body.
class BorderWalk {
  public:
    /// `strip`: as the piece sees it; `whole`: with what belongs to others.
    BorderWalk(const StepInput& in, const Strip& strip, const Strip& whole, const RestGuess& guess,
               int piece, CutCurves& curves)
        : in_(in), strip_(strip), whole_(whole), guess_(guess), piece_(piece), curves_(curves) {}

    Outline run() {
        collectSegments();
        countCurveEnds();
        collectFaceNodes();
        collectPoints();
        classify();
        if (segments_.empty() && !anyInside()) {
            return {};
        }
        addCurves();
        addBorder();
        return std::move(outline_);
    }

  private:
    bool isOwn(int triangle) const {
        return in_.pieceOfVertex[in_.mesh.triangle(triangle)[0]] == piece_;
    }

    void collectSegments() {
        for (const Segment& segment : curves_.segments) {
            if (isOwn(segment.triangle)) {
                segments_.push_back(segment);
            }
        }
    }

    // The body is entered where a curve ends on the border, and left where one starts.
    void countCurveEnds() {
        events_.assign(curves_.nodes.size(), 0);
        for (const Segment& segment : segments_) {
            --events_[segment.from];
            ++events_[segment.to];
        }
    }

    int eventOf(int node) const { return node < sizeOf(events_) ? events_[node] : 0; }

    void collectFaceNodes() {
        faceNodesOfEdge_.resize(strip_.edges.size());
        for (const auto& [key, node] : curves_.onFace) {
            if (strip_.edges[key.first].onBorder() && isOwn(key.second)) {
                faceNodesOfEdge_[key.first].push_back(node);
            }
        }
        for (std::vector<int>& nodes : faceNodesOfEdge_) {
            std::sort(nodes.begin(), nodes.end(), [&](int p, int q) {
                const double up = curves_.nodes[p].u;
                const double uq = curves_.nodes[q].u;
                return up != uq ? up < uq : p < q;
            });
        }
    }

    /// By strip node: the border edge that starts there, -1 where none does.
    std::vector<int> borderEdges() const {
        std::vector<int> edgeFrom(strip_.nodes.size(), -1);
        for (int e = 0; e < sizeOf(strip_.edges); ++e) {
            if (strip_.edges[e].onBorder() && std::exchange(edgeFrom[strip_.edges[e].a], e) >= 0) {
                throw StepFailure{"the strip is pinched"};
            }
        }
        return edgeFrom;
    }

    void collectPoints() {
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
            collectAtNode(v, edge);
            for (const int node : faceNodesOfEdge_[edge]) {
                points_.push_back(
                    {node, -1, eventOf(node), Link::stripEdge, edge, curves_.nodes[node].u});
            }
            v = strip_.edges[edge].b;
        } while (v != start);
    }

    void collectAtNode(int v, int edge) {
        std::vector<BorderPoint>& here = atNode_;
        here.clear();
        if (strip_.nodes[v].isCluster()) {
            addClusterPoints(v, here);
        } else {
            addVertexPoints(v, here);
        }
        addTouching(v, here);
        if (here.empty()) {
            here.push_back({-1, v, 0});
        }
        here.back().link = Link::stripEdge;
        here.back().edge = edge;
        points_.insert(points_.end(), here.begin(), here.end());
    }

    int ownNode(int v, int i) {
        return curves_.vertexNode(in_.mesh, strip_.nodes[v].vertices[i], strip_.nodes[v].layout);
    }

    // Several front vertices at one place, joined by front edges of length zero.
    void addClusterPoints(int v, std::vector<BorderPoint>& points) {
        const StripNode& strip = strip_.nodes[v];
        for (int i = 0; i < sizeOf(strip.vertices); ++i) {
            const int node = ownNode(v, i);
            const bool held = strip.joinsNext(i) || strip.joinsNext(i - 1);
            if (held || eventOf(node) != 0) {
                points.push_back(
                    {node, v, eventOf(node), strip.joinsNext(i) ? Link::zeroFront : Link::none});
            }
        }
    }

    void addVertexPoints(int v, std::vector<BorderPoint>& points) const {
        for (const int vertex : strip_.nodes[v].vertices) {
            const int node = curves_.nodeOfVertex.find(vertex);
            if (node >= 0 && eventOf(node) != 0) {
                points.push_back({node, v, eventOf(node), Link::none});
            }
        }
    }

    // Curves that end at a vertex of another piece lying here: the body is left before and
    // entered after what happens at the own vertices.
    void addTouching(int v, std::vector<BorderPoint>& here) {
        std::vector<BorderPoint> touching;
        for (const int vertex : strip_.nodes[v].touching) {
            const int node = curves_.nodeOfVertex.find(vertex);
            if (node >= 0 && eventOf(node) != 0) {
                touching.push_back({node, v, eventOf(node), Link::none});
            }
        }
        if (touching.empty()) {
            return;
        }
        const bool before = strip_.attachedBefore(v);
        const bool after = strip_.attachedAfter(v);
        const bool pair = touching.size() == 2 && touching[0].event + touching[1].event == 0;
        if (!here.empty() || (!before && !after) || (before == after && pair)) {
            for (const BorderPoint& point : touching) {
                here.insert(point.event < 0 ? here.begin() : here.end(), point);
            }
        } else if (touching.size() == 1 && sizeOf(strip_.nodes[v].vertices) == 1 &&
                   before != after) {
            endFrontAt(v, touching[0], here, before);
        } else {
            throw StepFailure{"a touching vertex carries the curve"};
        }
    }

    // Only the touching vertex carries the event: the edge from the front end to it is cut.
    void endFrontAt(int v, BorderPoint touching, std::vector<BorderPoint>& here, bool before) {
        const BorderPoint own{ownNode(v, 0), v, 0, before ? Link::touchedEdge : Link::none};
        if (before) {
            here = {own, touching};
        } else {
            touching.link = Link::touchedEdge;
            here = {touching, own};
        }
    }

    bool isFront(const BorderPoint& point) const {
        return point.link == Link::zeroFront ||
               (point.link == Link::stripEdge && strip_.edges[point.edge].frontOf >= 0);
    }

    bool anyInside() const {
        return std::any_of(points_.begin(), points_.end(),
                           [](const BorderPoint& p) { return p.inside; });
    }

    void classify() {
        bool anyEvent = false;
        for (const BorderPoint& point : points_) {
            if (std::abs(point.event) > 1) {
                throw StepFailure{"two curves end at one point of the blade's border"};
            }
            anyEvent |= point.event != 0;
        }
        if (anyEvent) {
            classifyByEvents();
        } else {
            const bool inside = std::any_of(points_.begin(), points_.end(),
                                            [&](const BorderPoint& p) { return isFront(p); });
            for (BorderPoint& point : points_) {
                point.inside = inside;
            }
        }
        for (const BorderPoint& point : points_) {
            if (isFront(point) && !point.inside) {
                throw StepFailure{"the front lies outside"};
            }
            if (point.inside && isInTheAir(point)) {
                throw StepFailure{"the air lies inside"};
            }
        }
    }

    /// A node of the blade far away from the body.
    bool isInTheAir(const BorderPoint& point) const {
        if (point.stripNode < 0 || in_.body.empty()) {
            return false;
        }
        const StripNode& node = strip_.nodes[point.stripNode];
        return node.vertices.empty() && !in_.body.overlaps({node.position, node.position});
    }

    // A point of which it is known that nothing is inside there; otherwise after the lowest prefix
    // sum, unless the front says otherwise.
    int firstPoint() const {
        if (const int known = pointInTheAir(); known >= 0) {
            return known;
        }
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

    int windingBefore(int first) const {
        if (isInTheAir(points_[first])) {
            return 0;
        }
        int winding = 0;
        for (int k = 0; k < sizeOf(points_); ++k) {
            const BorderPoint& point = points_[(first + k) % sizeOf(points_)];
            winding += point.event;
            if (isFront(point) && winding < 1) {
                return 1;
            }
        }
        return 0;
    }

    int pointInTheAir() const {
        const auto found = std::ranges::find_if(
            points_, [this](const BorderPoint& point) { return isInTheAir(point); });
        return found == points_.end() ? -1 : static_cast<int>(found - points_.begin());
    }

    void classifyByEvents() {
        const int n = sizeOf(points_);
        const int first = firstPoint();
        int winding = windingBefore(first);
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

    void addCurves() {
        for (const Segment& segment : segments_) {
            addEdge(segment.from, segment.to, OutlineKind::cut);
        }
    }

    void addEdge(int from, int to, OutlineKind kind) {
        outline_.edges.push_back({from, to, kind, piece_});
    }

    void addBorder() {
        const int n = sizeOf(points_);
        for (int i = 0; i < n; ++i) {
            const int j = (i + 1) % n;
            if (points_[i].link == Link::stripEdge) {
                addStripEdge(i, j);
            } else {
                addLink(i, j);
            }
        }
    }

    void addLink(int i, int j) {
        const BorderPoint& point = points_[i];
        if (point.link == Link::touchedEdge) {
            addTouchedEdge(i, j);
        } else if (point.inside && point.link == Link::none) {
            throw StepFailure{"the gap in the front lies inside"};
        } else if (point.inside) {
            addEdge(nodeAt(i), nodeAt(j), OutlineKind::front);
        }
    }

    void addTouchedEdge(int i, int j) {
        if (!points_[i].inside) {
            throw StepFailure{"the edge to a touching vertex lies outside"};
        }
        const int from = curves_.nodes[nodeAt(i)].a;
        const int to = curves_.nodes[nodeAt(j)].a;
        const int h = in_.mesh.findHalfEdge(from, to);
        if (h < 0 || curves_.onEdge.count(edgeOf(from, to)) > 0) {
            throw StepFailure{"no edge to a touching vertex"};
        }
        addEdge(nodeAt(i), nodeAt(j), OutlineKind::cut);
        curves_.segmentsOfTriangle[h / 3];
        curves_.segmentsOfTriangle[in_.mesh.twin(h) / 3];
    }

    void addStripEdge(int i, int j) {
        if (!points_[i].inside) {
            return;
        }
        const int edge = points_[i].edge;
        const int from = nodeAt(i);
        const int to = nodeAt(j);
        if (strip_.edges[edge].frontOf >= 0) {
            addEdge(from, to, OutlineKind::front);
            return;
        }
        const bool newRung = strip_.onNewRung(edge);
        if (!newRung) {
            requireNoStub(edge);
        }
        addFreePiece(from, to, parameterOf(points_[i]), parameterOf(points_[j]), newRung);
        if (newRung) {
            outline_.endBInside |= points_[i].stripNode == strip_.newRung.back();
            outline_.endAInside |= points_[j].stripNode == strip_.newRung.front();
        }
        const bool frontEnds = !points_[j].inside || points_[j].link != Link::stripEdge ||
                               !strip_.onNewRung(points_[j].edge);
        if (newRung && frontEnds) {
            outline_.front.push_back({parameterOf(points_[j]), to, false});
        }
    }

    // What lies behind the old rung is never swept: the body would stay connected there. So would
    // a piece on the other side of an older slit, into which the front runs on.
    void requireNoStub(int edge) const {
        const StripEdge& e = strip_.edges[edge];
        const bool onOldRung = strip_.isOld(e.a) && strip_.isOld(e.b);
        const bool besideFront =
            !whole_.nodes[e.a].vertices.empty() || !whole_.nodes[e.b].vertices.empty();
        if (onOldRung && besideFront) {
            throw StepFailure{"a free piece beside the old front"};
        }
    }

    double parameterOf(const BorderPoint& point) const {
        if (point.stripNode >= 0) {
            return strip_.nodes[point.stripNode].s;
        }
        const StripEdge& edge = strip_.edges[point.edge];
        const double from = strip_.nodes[edge.a].s;
        return from + (strip_.nodes[edge.b].s - from) * point.u;
    }

    Vec3 restOf(const CutNode& node) const {
        return node.kind == NodeKind::wall ? guess_.at(node.position) : node.rest;
    }

    // Samples a free piece at the spacing of the edges around.
    void addFreePiece(int from, int to, double sFrom, double sTo, bool newRung) {
        const CutNode start = curves_.nodes[from];
        const CutNode end = curves_.nodes[to];
        const double length = (end.position - start.position).norm();
        int previous = from;
        double at = 0;
        for (const double share :
             divideByEdgeLength(in_.edgeLengths, restOf(start), restOf(end), length)) {
            int next = to;
            if (share < 1) {
                CutNode node;
                node.position = start.position + (end.position - start.position) * share;
                node.layout = start.layout + (end.layout - start.layout) * share;
                curves_.nodes.push_back(node);
                next = sizeOf(curves_.nodes) - 1;
            }
            addEdge(previous, next, OutlineKind::free);
            if (newRung) {
                outline_.front.push_back({sFrom + (sTo - sFrom) * at, previous, true});
            }
            previous = next;
            at = share;
        }
    }

    int nodeAt(int i) {
        BorderPoint& point = points_[i];
        if (point.node >= 0) {
            return point.node;
        }
        const StripNode& at = strip_.nodes[point.stripNode];
        if (at.vertices.size() > 1) {
            throw StepFailure{"two front vertices at one point and no curve"};
        }
        if (at.vertices.size() == 1) {
            point.node = ownNode(point.stripNode, 0);
            return point.node;
        }
        CutNode node;
        node.position = at.position;
        node.layout = at.layout;
        curves_.nodes.push_back(node);
        point.node = sizeOf(curves_.nodes) - 1;
        return point.node;
    }

    const StepInput& in_;
    const Strip& strip_;
    const Strip& whole_;
    const RestGuess& guess_;
    int piece_;
    CutCurves& curves_;
    std::vector<Segment> segments_;
    std::vector<int> events_;
    std::vector<std::vector<int>> faceNodesOfEdge_;
    std::vector<BorderPoint> points_;
    std::vector<BorderPoint> atNode_;  ///< room for collectAtNode
    Outline outline_;
};

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

/// Nothing of the strip is of another piece.
bool belongsTo(int piece, const Strip& strip, const std::vector<int>& pieceOfVertex) {
    const auto isOwn = [&](int v) { return pieceOfVertex[v] == piece; };
    return std::ranges::all_of(strip.nodes, [&](const StripNode& node) {
        return std::ranges::all_of(node.vertices, isOwn) &&
               std::ranges::all_of(node.touching, isOwn);
    });
}

void join(Outline& sum, const Outline& part) {
    sum.edges.insert(sum.edges.end(), part.edges.begin(), part.edges.end());
    sum.front.insert(sum.front.end(), part.front.begin(), part.front.end());
    sum.endAInside |= part.endAInside;
    sum.endBInside |= part.endBInside;
}

// Runs of attached points stay together; those of all pieces take turns from B to A.
void sortRuns(std::vector<FrontPoint>& front) {
    std::vector<std::vector<FrontPoint>> runs(1);
    for (const FrontPoint& point : front) {
        runs.back().push_back(point);
        if (!point.attached) {
            runs.emplace_back();
        }
    }
    runs.pop_back();
    std::stable_sort(runs.begin(), runs.end(), [](const auto& p, const auto& q) {
        return p.front().s + p.back().s > q.front().s + q.back().s;
    });
    front.clear();
    for (const std::vector<FrontPoint>& run : runs) {
        front.insert(front.end(), run.begin(), run.end());
    }
}

void requireClosed(const std::vector<OutlineEdge>& edges, const std::vector<CutNode>& nodes) {
    std::vector<int> out(nodes.size(), 0);
    std::vector<int> in(nodes.size(), 0);
    for (const OutlineEdge& edge : edges) {
        ++out[edge.from];
        ++in[edge.to];
    }
    for (int i = 0; i < sizeOf(nodes); ++i) {
        const bool crossing = out[i] > 1 && nodes[i].kind != NodeKind::vertex;
        if (out[i] != in[i] || crossing) {
            throw StepFailure{"the border of the wall is not closed"};
        }
    }
}

}  // namespace

Outline traceOutline(const StepInput& in, const Strip& strip, const RestGuess& guess,
                     CutCurves& curves) {
    const std::set<int> pieces = piecesInStrip(in, strip, curves);
    Outline outline;
    for (const int piece : pieces) {
        if (belongsTo(piece, strip, in.pieceOfVertex)) {
            join(outline, BorderWalk(in, strip, strip, guess, piece, curves).run());
        } else {
            const Strip seen = strip.seenBy(piece, in.pieceOfVertex);
            join(outline, BorderWalk(in, seen, strip, guess, piece, curves).run());
        }
    }
    if (pieces.size() > 1) {
        sortRuns(outline.front);
    }
    requireClosed(outline.edges, curves.nodes);
    return outline;
}

}  // namespace kerf::cut
