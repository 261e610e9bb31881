#include "sim/cut/plan/wall.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "sim/cut/exact/directed_edges.h"
#include "sim/cut/exact/triangulation.h"
#include "sim/cut/plan/ears.h"
#include "sim/cut/plan/loops.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

constexpr double kCoincident = 1e-11;  // share of h
// Shares of the edge length there.
constexpr double kTallSheet = 1.2;
constexpr double kSteinerToNode = 0.6;
constexpr double kSteinerToEdge = 0.4;
constexpr int kMostSteinerPoints = 200000;
constexpr double kFlat = 1e-5;   // h: faces that are no farther out of one plane are one
constexpr double kLattices = 2;  // for each doubling of the edge length
constexpr int kChordRounds = 4;
// A point counts as inside a triangle of the strip a little beyond it (share of the blade).
constexpr double kRoomInStrip = 1e-6;

double cross2(const Vec2& u, const Vec2& v) {
    return u.x() * v.y() - u.y() * v.x();
}

std::vector<OutlineEdge> allEdges(const Sheet2d& sheet) {
    std::vector<OutlineEdge> edges = sheet.outer;
    for (const Loop& hole : sheet.holes) {
        edges.insert(edges.end(), hole.begin(), hole.end());
    }
    return edges;
}

bool triangleHas(const SurfaceMesh& mesh, int t, int v) {
    const Triangle& corners = mesh.triangle(t);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
}

bool liesOnFace(const SurfaceMesh& mesh, const CutNode& node, int t) {
    switch (node.kind) {
        case NodeKind::face:
            return node.a == t;
        case NodeKind::edge:
            return triangleHas(mesh, t, node.a) && triangleHas(mesh, t, node.b);
        case NodeKind::vertex:
            return triangleHas(mesh, t, node.a);
        case NodeKind::wall:
            break;
    }
    return false;
}

// A wall edge between two nodes of one surface face would lie IN the surface and close a chip of
// no thickness.
bool shareFace(const SurfaceMesh& mesh, const CutNode& p, const CutNode& q) {
    if (p.kind == NodeKind::wall || q.kind == NodeKind::wall) {
        return false;
    }
    if (p.kind == NodeKind::vertex && q.kind == NodeKind::vertex) {
        return mesh.findHalfEdge(p.a, q.a) >= 0;
    }
    const CutNode& first = p.kind == NodeKind::vertex ? q : p;
    const CutNode& second = p.kind == NodeKind::vertex ? p : q;
    if (first.kind == NodeKind::face) {
        return liesOnFace(mesh, second, first.a);
    }
    const int h = mesh.findHalfEdge(first.a, first.b);
    return h >= 0 &&
           (liesOnFace(mesh, second, h / 3) || liesOnFace(mesh, second, mesh.twin(h) / 3));
}

double distanceToFace(const SurfaceMesh& mesh, int face, const Vec3& p) {
    const Corners at = cornersOf(mesh, face);
    const Vec3 normal = areaNormal(at);
    return std::fabs(normal.dot(p - at[0])) / std::max(normal.norm(), 1e-300);
}

/// The two faces at a node on an edge, that around a node on a face twice; -1 for others.
std::array<int, 2> facesAt(const SurfaceMesh& mesh, const CutNode& node) {
    if (node.kind == NodeKind::face) {
        return {node.a, node.a};
    }
    const int h = node.kind == NodeKind::edge ? mesh.findHalfEdge(node.a, node.b) : -1;
    return h < 0 ? std::array{-1, -1} : std::array{h / 3, mesh.twin(h) / 3};
}

bool areNeighbors(const SurfaceMesh& mesh, int f, int g) {
    return mesh.twin(3 * f) / 3 == g || mesh.twin(3 * f + 1) / 3 == g ||
           mesh.twin(3 * f + 2) / 3 == g;
}

/// On two faces side by side, in one plane but for `tolerance`.
bool shareFlatFaces(const SurfaceMesh& mesh, const CutNode& p, const CutNode& q, double tolerance) {
    for (const int f : facesAt(mesh, p)) {
        for (const int g : facesAt(mesh, q)) {
            if (f >= 0 && g >= 0 && areNeighbors(mesh, f, g) &&
                distanceToFace(mesh, f, q.position) < tolerance &&
                distanceToFace(mesh, g, p.position) < tolerance) {
                return true;
            }
        }
    }
    return false;
}

/// Finds points that lie within a tolerance of each other.
class CoincidentPoints {
  public:
    CoincidentPoints(std::size_t most, double tolerance)
        : tolerance_(tolerance), buckets_(std::bit_ceil(2 * most + 1), -1) {}

    /// The number of a point there, -1 for none.
    int find(const Vec2& p) const {
        const Vec2 scaled = p / (kCells * tolerance_);
        const Vec2 rest = scaled - Vec2(std::floor(scaled.x()), std::floor(scaled.y()));
        const Cell cell = cellOf(p);
        for (int dx = firstAside(rest.x()); dx <= lastAside(rest.x()); ++dx) {
            for (int dy = firstAside(rest.y()); dy <= lastAside(rest.y()); ++dy) {
                if (const int found = findIn({cell.x + dx, cell.y + dy}, p); found >= 0) {
                    return found;
                }
            }
        }
        return -1;
    }

    void add(const Vec2& p, int number) {
        int& first = buckets_[bucketOf(cellOf(p))];
        points_.push_back({p, cellOf(p), number, first});
        first = sizeOf(points_) - 1;
    }

  private:
    static constexpr double kCells = 4;         // size of a cell, in tolerances
    static constexpr double kNearBorder = 0.3;  // of a cell: the next one may hold a point too

    struct Cell {
        long long x, y;
        bool operator==(const Cell&) const = default;
    };
    struct Point {
        Vec2 at;
        Cell cell;
        int number;
        int next;
    };

    Cell cellOf(const Vec2& p) const {
        return {static_cast<long long>(std::floor(p.x() / (kCells * tolerance_))),
                static_cast<long long>(std::floor(p.y() / (kCells * tolerance_)))};
    }
    std::size_t bucketOf(const Cell& cell) const {
        const std::uint64_t mixed = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15ull +
                                    static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4Full;
        return (mixed >> 32) & (buckets_.size() - 1);
    }
    static int firstAside(double rest) { return rest < kNearBorder ? -1 : 0; }
    static int lastAside(double rest) { return rest > 1 - kNearBorder ? 1 : 0; }

    /// The one that was added first.
    int findIn(const Cell& cell, const Vec2& p) const {
        int found = -1;
        for (int i = buckets_[bucketOf(cell)]; i >= 0; i = points_[i].next) {
            if (points_[i].cell == cell && (points_[i].at - p).cwiseAbs().maxCoeff() < tolerance_) {
                found = points_[i].number;
            }
        }
        return found;
    }

    double tolerance_;
    std::vector<int> buckets_;  ///< a power of two of them: the last point in each, -1 for none
    std::vector<Point> points_;
};

/// One sheet as a constrained Delaunay triangulation in the layout plane.
class SheetTriangulation {
  public:
    SheetTriangulation(const StepInput& in, const Strip& strip, const RestGuess& guess,
                       const Sheet2d& sheet, CutCurves& curves)
        : in_(in),
          strip_(strip),
          guess_(guess),
          nodes_(curves.nodes),
          edges_(allEdges(sheet)),
          bounds_(boundsOf()),
          plane_(enclosing(0), enclosing(1), enclosing(2)) {}

    std::vector<Triangle> run() {
        insertBorder();
        constrainBorder();
        markInside();
        insertSteinerPoints();
        flipChords();
        liftChords();
        return collect();
    }

  private:
    struct Box {
        Vec2 low = Vec2::Constant(1e300);
        Vec2 high = Vec2::Constant(-1e300);
    };

    Box boundsOf() const {
        Box box;
        for (const OutlineEdge& edge : edges_) {
            box.low = box.low.cwiseMin(nodes_[edge.from].layout);
            box.high = box.high.cwiseMax(nodes_[edge.from].layout);
        }
        return box;
    }

    Vec2 enclosing(int corner) const {
        const double size = (bounds_.high - bounds_.low).maxCoeff() + 1e-9;
        const std::array<Vec2, 3> around{Vec2(-20, -15), Vec2(20, -15), Vec2(0, 25)};
        return 0.5 * (bounds_.low + bounds_.high) + around[corner] * size;
    }

    // Coincident border nodes share a vertex of the triangulation; each corner later takes the
    // node of the border edge that bounds its wedge.
    void insertBorder() {
        plane_.reserve(edges_.size());
        CoincidentPoints known(2 * edges_.size(), kCoincident * in_.h);
        vertexOfNode_.assign(nodes_.size(), -1);
        nodeOfVertex_.assign(3, -1);
        for (const int node : nodesAlongBlade()) {
            const Vec2& p = nodes_[node].layout;
            int vertex = known.find(p);
            if (vertex < 0) {
                vertex = plane_.insert(p).vertex;
                if (vertex < 0) {
                    throw StepFailure{"a wall node lies outside the layout"};
                }
                known.add(p, vertex);
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
    std::vector<int> nodesAlongBlade() const {
        struct Place {
            double x, y;
            int node;
        };
        std::vector<Place> places;
        places.reserve(edges_.size());
        for (const OutlineEdge& edge : edges_) {
            const Vec2& at = nodes_[edge.from].layout;
            places.push_back({at.x(), at.y(), edge.from});
        }
        std::ranges::sort(places, [](const Place& p, const Place& q) {
            return p.x != q.x ? p.x > q.x : p.y != q.y ? p.y < q.y : p.node < q.node;
        });
        std::vector<int> order;
        order.reserve(places.size());
        for (const Place& place : places) {
            if (order.empty() || order.back() != place.node) {
                order.push_back(place.node);
            }
        }
        return order;
    }

    void constrainBorder() {
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

    bool isBorder(int t, int e) const {
        const Triangle& c = plane_.corners(t);
        return border_.has(c[e], c[(e + 1) % 3]);
    }

    void markInside() {
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

    void spreadMark(int t, int e, std::vector<int>& pending) {
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

    // Only single big steps make sheets tall enough to need points inside: hexagonal lattices, the
    // coarse ones first, each where its spacing is the edge length.
    void insertSteinerPoints() {
        const auto [most, least] = edgeLengthsAtBorder();
        if (bounds_.high.y() - bounds_.low.y() <= kTallSheet * least) {
            return;
        }
        const int levels = static_cast<int>(std::lround(kLattices * std::log2(most / least)));
        const double widest = levels == 0 && most > least ? std::sqrt(most * least) : most;
        for (int level = 0; level <= levels; ++level) {
            insertLattice(widest * std::exp2(-level / kLattices),
                          {level == 0 ? 1e300 : std::exp2(0.5 / kLattices),
                           level == levels ? 0 : std::exp2(-0.5 / kLattices)});
        }
    }

    struct Range {
        double most;
        double least;
    };

    Range edgeLengthsAtBorder() const {
        Range range{0, 1e300};
        for (const OutlineEdge& edge : edges_) {
            const CutNode& node = nodes_[edge.from];
            const double length = in_.edgeLengths.localEdgeLength(
                node.kind == NodeKind::wall ? guess_.at(node.position) : node.rest);
            range = {std::max(range.most, length), std::min(range.least, length)};
        }
        return range;
    }

    /// `share`: of the spacing that the edge length of a point may be.
    void insertLattice(double spacing, const Range& share) {
        const Vec2 extent = bounds_.high - bounds_.low;
        const double rowHeight = 0.866 * spacing;
        const double rows = std::floor(extent.y() / rowHeight);
        const double columns = std::floor(extent.x() / spacing);
        if (rows * columns > kMostSteinerPoints) {
            return;
        }
        const auto most = static_cast<std::size_t>((rows + 1) * (columns + 1));
        plane_.reserve(most);
        nodes_.reserve(nodes_.size() + most);
        for (int j = 0; j <= static_cast<int>(rows); ++j) {
            for (int i = 0; i <= static_cast<int>(columns); ++i) {
                const double shift = j % 2 == 1 ? 0.5 : 0.0;
                tryInsertSteiner({bounds_.low.x() + (i + shift) * spacing,
                                  bounds_.low.y() + (j + 0.5) * rowHeight},
                                 spacing, share);
            }
        }
    }

    void tryInsertSteiner(const Vec2& p, double spacing, const Range& share) {
        const Triangulation::Location at = plane_.locate(p);
        if (at.where != Triangulation::Where::inside || !plane_.marked(at.triangle) ||
            tooClose(at.triangle, p, spacing)) {
            return;
        }
        const Vec3 position = positionInStrip(p);
        const double edge = in_.edgeLengths.localEdgeLength(guess_.at(position));
        if (edge < share.most * spacing && edge >= share.least * spacing) {
            insertInside(p, position, at);
        }
    }

    void insertInside(const Vec2& layout, const Vec3& position, const Triangulation::Location& at) {
        CutNode node;
        node.layout = layout;
        node.position = position;
        nodes_.push_back(node);
        plane_.insert(layout, at);
        nodeOfVertex_.push_back(sizeOf(nodes_) - 1);
    }

    bool tooClose(int t, const Vec2& p, double spacing) const {
        for (int i = 0; i < 3; ++i) {
            const Vec2& a = plane_.point(plane_.corners(t)[i]);
            const Vec2& b = plane_.point(plane_.corners(t)[(i + 1) % 3]);
            if ((a - p).norm() < kSteinerToNode * spacing) {
                return true;
            }
            const double distance = std::fabs(cross2(b - a, p - a)) / (b - a).norm();
            if (plane_.constrained(t, i) && distance < kSteinerToEdge * spacing) {
                return true;
            }
        }
        return false;
    }

    // The strip's triangles follow each other along the blade: for each, how far they have come.
    void measureReach() {
        double reach = -1e300;
        for (const Triangle& t : strip_.triangles) {
            for (const int node : t) {
                reach = std::max(reach, strip_.nodes[node].layout.x());
            }
            reachOfTriangle_.push_back(reach);
        }
    }

    Vec3 positionInStrip(const Vec2& p) {
        if (reachOfTriangle_.empty()) {
            measureReach();
        }
        const double room = kRoomInStrip * (in_.blade.b - in_.blade.a).norm();
        const auto first = std::ranges::lower_bound(reachOfTriangle_, p.x() - room);
        for (std::size_t i = first - reachOfTriangle_.begin(); i < strip_.triangles.size(); ++i) {
            const Triangle& t = strip_.triangles[i];
            const StripNode& a = strip_.nodes[t[0]];
            const StripNode& b = strip_.nodes[t[1]];
            const StripNode& c = strip_.nodes[t[2]];
            const Vec2 u = b.layout - a.layout;
            const Vec2 v = c.layout - a.layout;
            const double area = cross2(u, v);
            if (std::fabs(area) < 1e-300) {
                continue;
            }
            const double wb = cross2(p - a.layout, v) / area;
            const double wc = cross2(u, p - a.layout) / area;
            if (wb >= -1e-9 && wc >= -1e-9 && wb + wc <= 1 + 1e-9) {
                return (1 - wb - wc) * a.position + wb * b.position + wc * c.position;
            }
        }
        throw StepFailure{"an inner wall point lies outside the strip"};
    }

    // Null for an inner point.
    const CutNode* borderNode(int vertex) const {
        return vertex < 3 || vertex >= borderVertices_ ? nullptr : &nodes_[nodeOfVertex_[vertex]];
    }

    bool isChord(int a, int b) const {
        const CutNode* p = borderNode(a);
        const CutNode* q = borderNode(b);
        return p != nullptr && q != nullptr && shareFace(in_.mesh, *p, *q);
    }

    bool isFlatChord(int a, int b) const {
        const CutNode* p = borderNode(a);
        const CutNode* q = borderNode(b);
        return p != nullptr && q != nullptr && shareFlatFaces(in_.mesh, *p, *q, kFlat * in_.h);
    }

    bool flipChord(int t, int e) {
        if (plane_.constrained(t, e) || plane_.neighbor(t, e) < 0) {
            return false;
        }
        const Triangle c = plane_.corners(t);
        if (!isChord(c[e], c[(e + 1) % 3]) ||
            isChord(c[(e + 2) % 3], plane_.oppositeVertex(t, e)) || !plane_.convex(t, e)) {
            return false;
        }
        plane_.flip(t, e);
        return true;
    }

    void flipChords() {
        bool flipped = true;
        for (int round = 0; round < kChordRounds && flipped; ++round) {
            flipped = false;
            for (int t = 0; t < plane_.size(); ++t) {
                for (int e = 0; e < 3 && plane_.marked(t); ++e) {
                    if (flipChord(t, e)) {
                        flipped = true;
                        break;
                    }
                }
            }
        }
    }

    // Where no flip helps, an inner point of the blade's surface leads the wall away from the face.
    void liftChords() {
        const int end = plane_.size();
        for (int t = 0; t < end; ++t) {
            for (int e = 0; e < 3 && plane_.marked(t); ++e) {
                if (liftChord(t, e)) {
                    break;
                }
            }
        }
    }

    bool liftChord(int t, int e) {
        const int a = plane_.corners(t)[e];
        const int b = plane_.corners(t)[(e + 1) % 3];
        const int neighbor = plane_.neighbor(t, e);
        if (plane_.constrained(t, e) || neighbor < 0 || !(isChord(a, b) || isFlatChord(a, b))) {
            return false;
        }
        const bool wider = doubleArea(t) >= doubleArea(neighbor);
        const int wide = wider ? t : neighbor;
        const int narrow = wider ? neighbor : t;
        const Vec2 p = centerOf(wide);
        const Triangulation::Location at = plane_.locate(p);
        if (at.where != Triangulation::Where::inside || at.triangle != wide) {
            return false;
        }
        insertInside(p, positionInStrip(p), at);
        for (int k = 0; k < 3; ++k) {  // unless the new point has flipped it already
            const Triangle& c = plane_.corners(narrow);
            if (edgeOf(c[k], c[(k + 1) % 3]) == edgeOf(a, b) && plane_.convex(narrow, k)) {
                plane_.flip(narrow, k);
                break;
            }
        }
        return true;
    }

    double doubleArea(int t) const {
        const Triangle& c = plane_.corners(t);
        return cross2(plane_.point(c[1]) - plane_.point(c[0]),
                      plane_.point(c[2]) - plane_.point(c[0]));
    }

    Vec2 centerOf(int t) const {
        const Triangle& c = plane_.corners(t);
        return (plane_.point(c[0]) + plane_.point(c[1]) + plane_.point(c[2])) / 3;
    }

    std::vector<Triangle> collect() const {
        std::vector<Triangle> result;
        result.reserve(plane_.size());
        for (int t = 0; t < plane_.size(); ++t) {
            if (plane_.marked(t)) {
                result.push_back({nodeOfCorner(t, 0), nodeOfCorner(t, 1), nodeOfCorner(t, 2)});
            }
        }
        return result;
    }

    // Where several border edges start at one vertex, turns clockwise about the corner to its own.
    int nodeOfCorner(int t, int corner) const {
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

    const StepInput& in_;
    const Strip& strip_;
    const RestGuess& guess_;
    std::vector<CutNode>& nodes_;
    std::vector<OutlineEdge> edges_;
    Box bounds_;
    Triangulation plane_;
    std::vector<int> vertexOfNode_;  ///< -1 for nodes of other sheets
    std::vector<int> nodeOfVertex_;  ///< -1 for the three enclosing ones; the border's come next
    int borderVertices_ = 0;         ///< vertices from here on are inner points
    DirectedEdges border_{0};        ///< places in edges_ by vertices
    std::vector<int> edgesFrom_;     ///< how many border edges start at each vertex
    std::vector<double> reachOfTriangle_;
};

std::vector<Triangle> triangulateSheet(const StepInput& in, const Strip& strip,
                                       const RestGuess& guess, const Sheet2d& sheet,
                                       CutCurves& curves) {
    const std::size_t nodesBefore = curves.nodes.size();
    try {
        return SheetTriangulation(in, strip, guess, sheet, curves).run();
    } catch (const StepFailure&) {
        curves.nodes.resize(nodesBefore);
        return cutEars(sheet, curves.nodes, in.h);
    }
}

void requireBorderOnce(const Outline& outline, const std::vector<WallSheet>& sheets,
                       std::size_t nodes) {
    DirectedEdges directed(nodes);
    std::size_t triangles = 0;
    for (const WallSheet& sheet : sheets) {
        triangles += sheet.triangles.size();
    }
    directed.reserve(3 * triangles);
    for (const WallSheet& sheet : sheets) {
        for (const Triangle& t : sheet.triangles) {
            for (int e = 0; e < 3; ++e) {
                if (!directed.add(t[e], t[(e + 1) % 3], 0)) {
                    throw StepFailure{"the wall uses an edge twice"};
                }
            }
        }
    }
    for (const OutlineEdge& edge : outline.edges) {
        if (!directed.has(edge.from, edge.to)) {
            throw StepFailure{"the wall misses a border edge"};
        }
    }
}

}  // namespace

std::vector<WallSheet> triangulateWall(const StepInput& in, const Strip& strip,
                                       const Outline& outline, CutCurves& curves) {
    std::vector<WallSheet> result;
    const RestGuess guess(in, strip, curves);
    for (const Sheet2d& sheet : nestLoops(in, outline, curves.nodes)) {
        result.push_back(
            {triangulateSheet(in, strip, guess, sheet, curves), sheet.outer.front().piece});
    }
    requireBorderOnce(outline, result, curves.nodes.size());
    return result;
}

}  // namespace kerf::cut
