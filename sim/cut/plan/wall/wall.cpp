#include "sim/cut/plan/wall/wall.h"

#include <bit>

#include "sim/cut/plan/strip/strip.h"
#include "sim/cut/plan/wall/ears.h"
#include "sim/cut/plan/wall/sheet_border.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

constexpr double kFlat = 1e-5;  // h: faces that are no farther out of one plane are one
constexpr int kChordRounds = 4;

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

/// Flips edges of a sheet that join two border nodes of one face of the mesh: they would lie in the
/// surface and enclose a chip of no thickness. Where no flip helps, an inner node lifts the sheet
/// off the face, and off two adjacent faces in one plane.
class Chords {
  public:
    Chords(const StepInput& in, const StripLocator& places, BorderedSheet& sheet)
        : in_(in), places_(places), sheet_(sheet), plane_(sheet.plane()) {}

    void clear() {
        flipAll();
        liftRest();
    }

  private:
    void flipAll() {
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
    void liftRest() {
        const int end = plane_.size();
        for (int t = 0; t < end; ++t) {
            for (int e = 0; e < 3 && plane_.marked(t); ++e) {
                if (liftChord(t, e)) {
                    break;
                }
            }
        }
    }

    bool isChord(int a, int b) const {
        const CutNode* p = sheet_.borderNode(a);
        const CutNode* q = sheet_.borderNode(b);
        return p != nullptr && q != nullptr && shareFace(in_.mesh, *p, *q);
    }

    bool isFlatChord(int a, int b) const {
        const CutNode* p = sheet_.borderNode(a);
        const CutNode* q = sheet_.borderNode(b);
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
        sheet_.addInner(p, places_.at(p), at);
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

    const StepInput& in_;
    const StripLocator& places_;
    BorderedSheet& sheet_;
    Triangulation& plane_;
};

// Shares of the edge length there.
constexpr double kTallSheet = 1.2;
constexpr double kSteinerToNode = 0.6;
constexpr double kSteinerToEdge = 0.4;
constexpr double kSteinerToGradedEdge = 0.6;
constexpr int kMostSteinerPoints = 200000;
constexpr double kLattices = 2;  // for each doubling of the edge length
constexpr double kRowHeight = 0.866;

/// Inserts nodes in a sheet that is taller than one edge, spaced by the local edge length. `nodes`:
/// those of the border.
class InnerPoints {
  public:
    InnerPoints(const StepInput& in, const RestGuess& guess, const StripLocator& places,
                const std::vector<CutNode>& nodes, BorderedSheet& sheet)
        : in_(in),
          guess_(guess),
          places_(places),
          nodes_(nodes),
          sheet_(sheet),
          plane_(sheet.plane()) {}

    // Only single big steps make sheets tall enough to need points inside: hexagonal lattices, the
    // coarse ones first, each where its spacing is the edge length.
    void run() {
        auto [most, least] = edgeLengthsAtBorder();
        if (sheet_.bounds().high.y() - sheet_.bounds().low.y() <= kTallSheet * least) {
            return;
        }
        if (in_.grading.isOn()) {
            lengthAt_ = lengthsAtBorder();
            most *= in_.grading.most;
        }
        const int levels = static_cast<int>(std::lround(kLattices * std::log2(most / least)));
        const double widest = levels == 0 && most > least ? std::sqrt(most * least) : most;
        for (int level = 0; level <= levels; ++level) {
            insertLattice(widest * std::exp2(-level / kLattices),
                          {level == 0 ? 1e300 : std::exp2(0.5 / kLattices),
                           level == levels ? 0 : std::exp2(-0.5 / kLattices)});
        }
    }

  private:
    struct Range {
        double most;
        double least;
    };

    Range edgeLengthsAtBorder() const {
        Range range{0, 1e300};
        for (const OutlineEdge& edge : sheet_.border()) {
            const CutNode& node = nodes_[edge.from];
            const double length = localEdgeLength(node);
            range = {std::max(range.most, length), std::min(range.least, length)};
        }
        return range;
    }

    double localEdgeLength(const CutNode& node) const {
        return in_.edgeLengths.localEdgeLength(
            node.kind == NodeKind::wall ? guess_.at(node.position) : node.rest);
    }

    /// By vertex of the triangulation: the length of the edges there, that of the skin at the rim.
    std::vector<double> lengthsAtBorder() const {
        std::vector<double> lengths;
        for (const OutlineEdge& edge : sheet_.border()) {
            const CutNode& from = nodes_[edge.from];
            const CutNode& to = nodes_[edge.to];
            const double local = localEdgeLength(from);
            const double length = edge.kind == OutlineKind::cut
                                      ? local
                                      : std::max(local, (to.position - from.position).norm());
            for (const int node : {edge.from, edge.to}) {
                const std::size_t vertex = sheet_.vertexOf(node);
                lengths.resize(std::max(lengths.size(), vertex + 1), 1e300);
                lengths[vertex] = std::min(lengths[vertex], length);
            }
        }
        return lengths;
    }

    /// How long edges may be at a place of a triangle: as those at its corners grow.
    double grownLength(int triangle, const Vec2& p) const {
        double grown = 1e300;
        for (const int corner : plane_.corners(triangle)) {
            grown = std::min(
                grown, in_.grading.grown(lengthAt_[corner], (plane_.point(corner) - p).norm()));
        }
        return grown;
    }

    /// A hexagonal lattice over a sheet.
    struct Lattice {
        Vec2 low;
        double spacing;
        Range share;  ///< of the spacing that the edge length of a point may be
        int rows, columns;
        Vec2 at(int i, int j) const {
            const double shift = j % 2 == 1 ? 0.5 : 0.0;
            return {low.x() + (i + shift) * spacing, low.y() + (j + 0.5) * (kRowHeight * spacing)};
        }
    };

    void insertLattice(double spacing, const Range& share) {
        const Vec2 extent = sheet_.bounds().high - sheet_.bounds().low;
        const double rows = std::floor(extent.y() / (kRowHeight * spacing));
        const double columns = std::floor(extent.x() / spacing);
        if (rows * columns > kMostSteinerPoints) {
            return;
        }
        const Lattice lattice{sheet_.bounds().low, spacing, share, static_cast<int>(rows) + 1,
                              static_cast<int>(columns) + 1};
        if (in_.grading.isOn()) {
            const unsigned longer = std::max(lattice.rows, lattice.columns);
            insertBlock(lattice, 0, 0, static_cast<int>(std::bit_ceil(longer)));
            return;
        }
        plane_.reserve(static_cast<std::size_t>(lattice.rows) * lattice.columns);
        for (int j = 0; j < lattice.rows; ++j) {
            for (int i = 0; i < lattice.columns; ++i) {
                tryInsertSteiner(lattice, i, j);
            }
        }
    }

    /// The middle, then quarter by quarter: neighbours follow each other, and few edges turn twice.
    void insertBlock(const Lattice& lattice, int i, int j, int size) {
        if (i >= lattice.columns || j >= lattice.rows) {
            return;
        }
        const int half = size / 2;
        const double idle = tryInsertSteiner(lattice, i + half, j + half);
        if (half == 0 || idle > size * lattice.spacing) {
            return;
        }
        for (const auto& [x, y] : {std::array{0, 0}, {half, 0}, {half, half}, {0, half}}) {
            insertBlock(lattice, i + x, j + y, half);
        }
    }

    /// Returns how far around no point is wanted [m].
    double tryInsertSteiner(const Lattice& lattice, int i, int j) {
        const Vec2 p = lattice.at(i, j);
        const Triangulation::Location at = plane_.locate(p);
        if (at.where != Triangulation::Where::inside || !plane_.marked(at.triangle)) {
            return at.where == Triangulation::Where::inside ? distanceToBorder(at.triangle, p) : 0;
        }
        if (tooClose(at.triangle, p, lattice.spacing)) {
            return 0;
        }
        const Vec3 position = places_.at(p);
        const double most = in_.grading.most * in_.edgeLengths.localEdgeLength(guess_.at(position));
        const double grown = in_.grading.isOn() ? grownLength(at.triangle, p) : most;
        const double edge = in_.edgeLengths.isEven() ? grown : std::min(grown, most);
        const double wanted = std::min(edge, most);
        const double limit = lattice.share.most * lattice.spacing;
        if (wanted < limit && wanted >= lattice.share.least * lattice.spacing) {
            sheet_.addInner(p, position, at);
            lengthAt_.push_back(edge);
        }
        return wanted < limit ? 0 : in_.grading.wayFrom(limit, edge);
    }

    /// About, for a place outside the sheet.
    double distanceToBorder(int triangle, const Vec2& p) const {
        double nearest = 1e300;
        for (const int corner : plane_.corners(triangle)) {
            nearest = std::min(nearest, (plane_.point(corner) - p).norm());
        }
        return 0.5 * nearest;
    }

    bool tooClose(int t, const Vec2& p, double spacing) const {
        for (int i = 0; i < 3; ++i) {
            const Vec2& a = plane_.point(plane_.corners(t)[i]);
            const Vec2& b = plane_.point(plane_.corners(t)[(i + 1) % 3]);
            if ((a - p).norm() < kSteinerToNode * spacing) {
                return true;
            }
            const double distance = std::fabs(cross2(b - a, p - a)) / (b - a).norm();
            const double least = in_.grading.isOn() ? kSteinerToGradedEdge : kSteinerToEdge;
            if (plane_.constrained(t, i) && distance < least * spacing) {
                return true;
            }
        }
        return false;
    }

    const StepInput& in_;
    const RestGuess& guess_;
    const StripLocator& places_;
    const std::vector<CutNode>& nodes_;
    BorderedSheet& sheet_;
    Triangulation& plane_;
    std::vector<double> lengthAt_;  ///< by vertex of the triangulation, where edges grow
};

}  // namespace

Wall triangulateWall(const StepInput& in, const Strip& strip, const Outline& outline,
                     const CutCurves& curves) {
    Wall wall;
    const std::vector<CutNode>& nodes = curves.nodes;
    const RestGuess guess(in, strip, curves);
    const StripLocator places(in.blade, strip);
    for (const Sheet2d& loops : nestLoops(in, outline, nodes)) {
        const int piece = loops.outer.front().piece;
        try {
            BorderedSheet sheet(loops, nodes, sizeOf(nodes) + sizeOf(wall.nodes), in.h);
            InnerPoints(in, guess, places, nodes, sheet).run();
            Chords(in, places, sheet).clear();
            wall.sheets.push_back({sheet.triangles(), piece});
            wall.nodes.insert(wall.nodes.end(), sheet.inner().begin(), sheet.inner().end());
        } catch (const StepFailure&) {
            wall.sheets.push_back({cutEars(loops, nodes, in.h), piece});
        }
    }
    return wall;
}

}  // namespace kerf::cut
