#include "sim/cut/plan/intersections.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "sim/base/predicates.h"
#include "sim/base/sort_unique.h"
#include "sim/cut/plan/front_profile.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Curve nodes keep this distance (as parameter or weight) from the ends of their edge and the
// border of their triangle, so that positions of neighbours in one edge stay distinct.
constexpr double kLeastParameter = 1e-9;
// A point that lies no farther outside of a triangle, as a weight, is on its border; and one no
// farther from the end of an edge, as a share, is at that end.
constexpr double kBeside = 1e-3;
// Stands for the sign of a vertex that both triangles share.
constexpr int kShared = 9;
// Far more than what rounding does to the distance from a plane, as a share of all lengths in it.
constexpr double kApartError = 1e-13;

constexpr std::array<std::array<int, 2>, 3> kOtherCorners{{{1, 2}, {2, 0}, {0, 1}}};

/// The corners of a triangle as rows, the last one twice: so many numbers go together.
using ThreePoints = Eigen::Matrix<double, 4, 3>;

ThreePoints rowsOf(const std::array<Vec3, 3>& at) {
    ThreePoints rows;
    for (int axis = 0; axis < 3; ++axis) {
        rows.col(axis) << at[0][axis], at[1][axis], at[2][axis], at[2][axis];
    }
    return rows;
}

/// A triangle of the mesh as the predicates see it.
struct SeenTriangle {
    Triangle ids{};
    std::array<Vec3, 3> at;
    ThreePoints points;       ///< the same, but where it lies behind the front
    Vec3 sum = Vec3::Zero();  ///< of the three
    /// Corner numbers in canonical order, and whether that order reverses the orientation; only
    /// once they are `ordered`.
    std::array<int, 3> order{0, 1, 2};
    int parity = 1;
    bool ordered = false;
};

/// Signs of the corners of one triangle against the plane of the other.
struct Signs {
    std::array<int, 3> sign{};
    bool separated() const {
        const auto allAre = [&](int s) {
            return std::all_of(sign.begin(), sign.end(),
                               [s](int x) { return x == s || x == kShared; });
        };
        return allAre(1) || allAre(-1);
    }
};

struct Crossing {
    int direction = 0;  ///< +1: from the negative to the positive side, -1: back, 0: none
    double t = 0;
    Vec3 weights = Vec3::Zero();
};

Vec2 project(const Vec3& p, int dropped) {
    return {p[(dropped + 1) % 3], p[(dropped + 2) % 3]};
}

bool hasZeroArea(const std::array<Vec3, 3>& abc) {
    for (int axis = 0; axis < 3; ++axis) {
        if (orient2d(project(abc[0], axis), project(abc[1], axis), project(abc[2], axis)) != 0) {
            return false;
        }
    }
    return true;
}

// An edge in the plane of the triangle: apart by an exact test in the dominant projection, or the
// triangle has no area (then its edges carry the crossing), or degenerate.
void requireApartInPlane(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& abc) {
    const Vec3 normal = areaNormal(abc);
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    const int dropped = static_cast<int>(largest);
    const Vec2 p2 = project(p, dropped);
    const Vec2 q2 = project(q, dropped);
    std::array<Vec2, 3> abc2;
    int left = 0;
    int right = 0;
    for (int i = 0; i < 3; ++i) {
        abc2[i] = project(abc[i], dropped);
        const int side = orient2d(p2, q2, abc2[i]);
        left += side > 0;
        right += side < 0;
    }
    if (left == 3 || right == 3 || hasZeroArea(abc)) {
        return;
    }
    const int orientation = orient2d(abc2[0], abc2[1], abc2[2]);
    for (int i = 0; i < 3; ++i) {
        const Vec2& from = abc2[i];
        const Vec2& to = abc2[(i + 1) % 3];
        if (orient2d(from, to, p2) * orientation < 0 && orient2d(from, to, q2) * orientation < 0) {
            return;
        }
    }
    throw StepFailure{"degenerate: an edge lies in a triangle"};
}

Crossing crossingOf(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& abc) {
    const Orientation ofP = orient3d(abc[0], abc[1], abc[2], p);
    const Orientation ofQ = orient3d(abc[0], abc[1], abc[2], q);
    Vec3 beside;
    for (int i = 0; i < 3; ++i) {
        beside[i] = orient3d(p, q, abc[i], abc[(i + 1) % 3]).value;
    }
    const double sum = beside[0] + beside[1] + beside[2];
    const double fromP = std::fabs(ofP.value);
    return {ofP.sign < 0 ? 1 : -1, fromP / (fromP + std::fabs(ofQ.value)),
            Vec3(beside[1], beside[2], beside[0]) / sum};
}

// The segment pq against the triangle abc, from the signs of p and q against its plane.
Crossing pierce(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& abc, int signOfP,
                int signOfQ) {
    if (signOfP == 0 && signOfQ == 0) {
        requireApartInPlane(p, q, abc);
        return {};
    }
    if (signOfP == signOfQ) {
        return {};
    }
    bool positive = false;
    bool negative = false;
    bool onEdge = false;
    for (int i = 0; i < 3; ++i) {
        const int beside = orientSign3d(p, q, abc[i], abc[(i + 1) % 3]);
        positive |= beside > 0;
        negative |= beside < 0;
        onEdge |= beside == 0;
    }
    if (positive && negative) {
        return {};
    }
    if (onEdge) {
        throw StepFailure{"degenerate: an edge meets an edge"};
    }
    if (signOfP == 0 || signOfQ == 0) {
        throw StepFailure{"degenerate: a vertex lies on a triangle"};
    }
    return crossingOf(p, q, abc);
}

// Rows of wall triangles behind the front that the blade can't meet again so soon.
constexpr int kFringeRings = 5;

/// Works through all pairs of triangles.
class Intersector {
  public:
    Intersector(const StepInput& in, const Strip& strip, const PredicatePositions& positions)
        : in_(in), mesh_(in.mesh), strip_(strip), positions_(positions), front_(in.blade, strip) {
        for (const RungNode& node : in.rung) {
            if (node.vertex >= 0) {
                rungVertices_.push_back(node.vertex);
            }
        }
        sortUnique(rungVertices_);
    }

    CutCurves run() {
        gatherEntries();
        for (int s = 0; s < sizeOf(strip_.triangles); ++s) {
            intersectStripTriangle(s);
        }
        for (auto& [edge, hits] : curves_.onEdge) {
            orderAlongEdge(hits);
        }
        for (CutNode& node : curves_.nodes) {
            place(node);
        }
        return std::move(curves_);
    }

  private:
    /// A triangle of the strip.
    struct StripCorners {
        int index = -1;
        std::array<Vec3, 3> at;
        ThreePoints points;
        Vec3 sum = Vec3::Zero();
        double reach = 0;  ///< largest coordinate
    };

    /// The vertex that the two triangles share.
    struct SharedVertex {
        int count = 0;
        int vertex = -1;
        int meshCorner = -1;
        int stripCorner = -1;
        bool any() const { return count > 0; }
    };

    /// The pair in hand.
    struct Pair {
        int m;
        int s;
        const SeenTriangle& mesh;
        const std::array<Vec3, 3>& strip;
        SharedVertex shared;
        Signs meshSigns{};   ///< of the mesh corners against the strip triangle
        Signs stripSigns{};  ///< of the strip corners against the mesh triangle in canonical order
        int entry = -1;
        int exit = -1;
        int hits = 0;
    };

    void gatherEntries() {
        std::vector<Vec3> points;
        points.reserve(strip_.nodes.size());
        inFrame_.reserve(strip_.nodes.size());
        for (const StripNode& node : strip_.nodes) {
            points.push_back(node.position);
            inFrame_.push_back(in_.broadPhase.toFrame(node.position));
        }
        drift_ = predicateDrift();
        std::vector<int> near = in_.broadPhase.cover(points, drift_);
        const std::vector<BroadPhase::Entry>& entries = in_.broadPhase.entries();
        cornersOf_.assign(entries.size(), -1);
        std::erase_if(near, [&](int place) {
            const int m = entries[place].triangle;
            SeenTriangle corners;
            look(m, corners);
            if (isOwnWall(m) && front_.isBehind(corners.ids, corners.at)) {
                return true;
            }
            corners.points = rowsOf(corners.at);
            cornersOf_[place] = sizeOf(corners_);
            corners_.push_back(corners);
            return false;
        });
        ahead_ = in_.broadPhase.binsOf(near);
        curves_.nodes.reserve(2 * strip_.nodes.size());
    }

    // Most triangles of a strip lie inside the body, near nothing but walls behind the front.
    void intersectStripTriangle(int s) {
        Bounds box;
        for (const int node : strip_.triangles[s]) {
            box.add(inFrame_[node]);
        }
        in_.broadPhase.findEntries(box, drift_, ahead_, found_);
        if (found_.empty()) {
            return;
        }
        const StripCorners strip = lookAtStrip(s);
        for (const int entry : found_) {
            intersectPair(entry, strip);
        }
    }

    /// Makes it the triangle in hand.
    StripCorners lookAtStrip(int s) {
        StripCorners strip;
        strip.index = s;
        stripVertices_.clear();
        for (int j = 0; j < 3; ++j) {
            const StripNode& node = strip_.nodes[strip_.triangles[s][j]];
            strip.at[j] = node.position;
            strip.sum += node.position;
            strip.reach = std::max(strip.reach, node.position.cwiseAbs().maxCoeff());
            for (const std::vector<int>* vertices : {&node.vertices, &node.touching}) {
                for (const int v : *vertices) {
                    stripVertices_.push_back({v, j});
                }
            }
        }
        strip.points = rowsOf(strip.at);
        return strip;
    }

    // How far from its real position a vertex may be seen.
    double predicateDrift() const {
        const Attempt& attempt = in_.attempt;
        const bool onSurface = attempt.seenAt != SeenAt::ownPlace;
        const double closing = onSurface ? kCloseDistance : attempt.closing;
        const double shares = closing + 2 * attempt.tolerance;
        return shares * in_.h + in_.opening.reach() + positions_.asideReach();
    }

    // Walls of this stroke may lie in the plane of the blade, where signs cost the most: most of
    // those that do not lie behind the front are told apart before.
    void intersectPair(int entry, const StripCorners& strip) {
        SeenTriangle& corners = corners_[cornersOf_[entry]];
        const SharedVertex shared = sharedVertex(corners.ids);
        if (shared.count >= 2 || areApart(strip, corners, shared)) {
            return;
        }
        putInOrder(corners);
        const int m = in_.broadPhase.entries()[entry].triangle;
        Pair pair{m, strip.index, corners, strip.at, shared};
        if (!signMeshCorners(pair) || !signStripCorners(pair)) {
            return;
        }
        meshEdgesAgainstStrip(pair);
        stripEdgesAgainstMesh(pair);
        if (pair.shared.any()) {
            endAtSharedVertex(pair);
        }
        if (pair.hits == 0) {
            return;
        }
        if (pair.hits != 2 || pair.entry < 0 || pair.exit < 0) {
            throw StepFailure{"two triangles meet in an impossible way"};
        }
        if (isFringe(m)) {
            throw StepFailure{"the blade meets the walls that it has just made"};
        }
        curves_.segmentsOfTriangle[m].push_back(sizeOf(curves_.segments));
        curves_.segments.push_back({m, pair.s, pair.entry, pair.exit});
    }

    bool isOwnWall(int m) const {
        return mesh_.kind(m) == SurfaceKind::wall && mesh_.wallLabel(m) / 2 == in_.stroke;
    }

    void look(int m, SeenTriangle& corners) const {
        const Triangle& ids = corners.ids = mesh_.triangle(m);
        for (int i = 0; i < 3; ++i) {
            corners.at[i] = positions_.at(ids[i]);
            corners.sum += corners.at[i];
        }
    }

    static void putInOrder(SeenTriangle& corners) {
        if (std::exchange(corners.ordered, true)) {
            return;
        }
        const Triangle& ids = corners.ids;
        const auto sortPair = [&](int u, int v) {
            int& first = corners.order[u];
            int& second = corners.order[v];
            if (comesBefore(corners.at[second], ids[second], corners.at[first], ids[first])) {
                std::swap(first, second);
                corners.parity = -corners.parity;
            }
        };
        sortPair(0, 1);
        sortPair(1, 2);
        sortPair(0, 1);
    }

    SharedVertex sharedVertex(const Triangle& ids) const {
        SharedVertex shared;
        for (const auto& [v, stripCorner] : stripVertices_) {
            for (int i = 0; i < 3; ++i) {
                if (ids[i] == v) {
                    shared = {shared.count + 1, v, i, stripCorner};
                }
            }
        }
        return shared;
    }

    bool onRung(int v) const { return std::ranges::binary_search(rungVertices_, v); }

    /// Vertices of walls near the rung. Few steps ask.
    const std::set<int>& fringe() {
        if (!fringe_.empty()) {
            return fringe_;
        }
        fringe_ = {rungVertices_.begin(), rungVertices_.end()};
        for (int ring = 1; ring < kFringeRings; ++ring) {
            std::set<int> wider = fringe_;
            for (const int v : fringe_) {
                mesh_.forEachOutgoing(v, [&](int h) {
                    if (mesh_.kind(h / 3) == SurfaceKind::wall) {
                        wider.insert({mesh_.target(h), mesh_.apex(h)});
                    }
                });
            }
            fringe_ = std::move(wider);
        }
        return fringe_;
    }

    /// A wall of this transit beside its front. Those of earlier transits of the stroke may be
    /// crossed; what a cut leaves of them has corners older than the transit.
    bool isFringe(int m) {
        if (!isOwnWall(m)) {
            return false;
        }
        const Triangle& ids = mesh_.triangle(m);
        return std::all_of(ids.begin(), ids.end(),
                           [&](int v) { return v >= in_.firstVertexOfTransit; }) &&
               std::any_of(ids.begin(), ids.end(), [&](int v) { return fringe().count(v) > 0; });
    }

    // False where the mesh triangle lies on one side of the strip triangle.
    static bool signMeshCorners(Pair& pair) {
        for (int i = 0; i < 3; ++i) {
            pair.meshSigns.sign[i] =
                pair.shared.any() && i == pair.shared.meshCorner
                    ? kShared
                    : orientSign3d(pair.strip[0], pair.strip[1], pair.strip[2], pair.mesh.at[i]);
        }
        return !pair.meshSigns.separated();
    }

    // Whether some plane, found without much ado, lies between the two; but for a shared vertex.
    static bool areApart(const StripCorners& strip, const SeenTriangle& mesh,
                         const SharedVertex& shared) {
        if (shared.any() && mesh.at[shared.meshCorner] != strip.at[shared.stripCorner]) {
            return false;
        }
        const Vec3 normal = strip.sum - mesh.sum;  // from the middle of one to that of the other
        const Eigen::Vector4d ofStrip = strip.points * normal;
        const Eigen::Vector4d ofMesh = mesh.points * normal;
        const double length = normal.cwiseAbs().sum();
        const double error = kApartError * length * (strip.reach + length);
        if (!shared.any()) {
            return std::min({ofStrip[0], ofStrip[1], ofStrip[2]}) -
                       std::max({ofMesh[0], ofMesh[1], ofMesh[2]}) >
                   error;
        }
        const double origin = ofStrip[shared.stripCorner];
        const auto [p, q] = kOtherCorners[shared.stripCorner];
        const auto [u, v] = kOtherCorners[shared.meshCorner];
        return std::min(ofStrip[p], ofStrip[q]) - origin > error &&
               std::max(ofMesh[u], ofMesh[v]) - origin < -error;
    }

    bool signStripCorners(Pair& pair) const {
        const auto& order = pair.mesh.order;
        for (int i = 0; i < 3; ++i) {
            if (pair.shared.any() && i == pair.shared.stripCorner) {
                pair.stripSigns.sign[i] = kShared;
                continue;
            }
            pair.stripSigns.sign[i] = orientSign3d(pair.mesh.at[order[0]], pair.mesh.at[order[1]],
                                                   pair.mesh.at[order[2]], pair.strip[i]);
        }
        return !pair.stripSigns.separated();
    }

    static void count(Pair& pair, bool isExit, int node) {
        ++pair.hits;
        (isExit ? pair.exit : pair.entry) = node;
    }

    // E nodes. Along a counter-clockwise half-edge from - to + the curve leaves the triangle.
    void meshEdgesAgainstStrip(Pair& pair) {
        const Triangle& ids = mesh_.triangle(pair.m);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            if ((pair.shared.any() &&
                 (i == pair.shared.meshCorner || j == pair.shared.meshCorner)) ||
                (onRung(ids[i]) && onRung(ids[j]))) {
                continue;
            }
            const bool swapped = comesBefore(pair.mesh.at[j], ids[j], pair.mesh.at[i], ids[i]);
            const int from = swapped ? j : i;
            const int to = swapped ? i : j;
            const Crossing crossing = pierce(pair.mesh.at[from], pair.mesh.at[to], pair.strip,
                                             pair.meshSigns.sign[from], pair.meshSigns.sign[to]);
            if (crossing.direction != 0) {
                count(pair, (swapped ? -crossing.direction : crossing.direction) > 0,
                      edgeNode(pair.s, ids[from], ids[to], crossing));
            }
        }
    }

    /// What is seen beside the strip, but lies in it, is met where it lies.
    double parameterOf(int from, int to, const Crossing& crossing) const {
        if (positions_.isAside(from) && crossing.t < kBeside) {
            return 0;
        }
        return positions_.isAside(to) && crossing.t > 1 - kBeside ? 1 : crossing.t;
    }

    int edgeNode(int s, int from, int to, const Crossing& crossing) {
        std::vector<EdgeHit>& hits = curves_.onEdge[edgeOf(from, to)];
        for (const EdgeHit& hit : hits) {
            if (hit.stripTriangle == s) {
                return hit.node;
            }
        }
        CutNode node;
        node.kind = NodeKind::edge;
        node.a = from;
        node.b = to;
        node.t = parameterOf(from, to, crossing);
        const Triangle& corners = strip_.triangles[s];
        for (int i = 0; i < 3; ++i) {
            node.layout += crossing.weights[i] * strip_.nodes[corners[i]].layout;
        }
        hits.push_back({s, addNode(node)});
        return hits.back().node;
    }

    // F nodes. Along a counter-clockwise half-edge of the strip from outside to inside the curve
    // leaves the triangle.
    void stripEdgesAgainstMesh(Pair& pair) {
        const Triangle& ids = strip_.triangles[pair.s];
        const auto& order = pair.mesh.order;
        const std::array<Vec3, 3> canonical{pair.mesh.at[order[0]], pair.mesh.at[order[1]],
                                            pair.mesh.at[order[2]]};
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3;
            const int edge = strip_.triangleEdges[pair.s][i];
            if ((pair.shared.any() &&
                 (i == pair.shared.stripCorner || j == pair.shared.stripCorner)) ||
                strip_.edges[edge].frontOf == in_.pieceOfVertex[mesh_.triangle(pair.m)[0]]) {
                continue;
            }
            const bool swapped = ids[i] > ids[j];
            const int from = swapped ? j : i;
            const int to = swapped ? i : j;
            Crossing crossing = pierce(pair.strip[from], pair.strip[to], canonical,
                                       pair.stripSigns.sign[from], pair.stripSigns.sign[to]);
            if (crossing.direction != 0) {
                meetInStrip(pair, pair.strip[from], pair.strip[to], crossing);
                const int outward = crossing.direction * pair.mesh.parity;
                count(pair, (swapped ? -outward : outward) < 0,
                      faceNode(pair, edge, ids[from], ids[to], crossing));
            }
        }
    }

    /// The same for a triangle with a corner that is seen beside the strip.
    void meetInStrip(const Pair& pair, const Vec3& p, const Vec3& q, Crossing& crossing) const {
        const Triangle& ids = mesh_.triangle(pair.m);
        if (std::ranges::none_of(ids, [&](int v) { return positions_.isAside(v); })) {
            return;
        }
        std::array<Vec3, 3> at;
        for (int i = 0; i < 3; ++i) {
            at[i] = positions_.inStrip(ids[pair.mesh.order[i]]);
        }
        const Vec3 weights = crossingOf(p, q, at).weights;
        if (weights.allFinite() && weights.minCoeff() > -kBeside) {
            crossing.weights = weights.cwiseMax(0.0) / weights.cwiseMax(0.0).sum();
        }
    }

    int faceNode(const Pair& pair, int edge, int from, int to, const Crossing& crossing) {
        const auto known = curves_.onFace.find({edge, pair.m});
        if (known != curves_.onFace.end()) {
            return known->second;
        }
        CutNode node;
        node.kind = NodeKind::face;
        node.a = pair.m;
        node.stripEdge = edge;
        for (int i = 0; i < 3; ++i) {
            node.weights[pair.mesh.order[i]] = crossing.weights[i];
        }
        const Vec2& start = strip_.nodes[from].layout;
        node.layout = start + (strip_.nodes[to].layout - start) * crossing.t;
        node.u = strip_.edges[edge].a == from ? crossing.t : 1 - crossing.t;
        const int id = addNode(node);
        curves_.onFace[{edge, pair.m}] = id;
        curves_.faceNodesOfTriangle[pair.m].push_back(id);
        return id;
    }

    void endAtSharedVertex(Pair& pair) {
        if (pair.hits == 0) {
            return;
        }
        if (pair.hits != 1) {
            throw StepFailure{"two triangles meet twice beside a shared vertex"};
        }
        const StripNode& corner = strip_.nodes[strip_.triangles[pair.s][pair.shared.stripCorner]];
        count(pair, pair.exit < 0, curves_.vertexNode(mesh_, pair.shared.vertex, corner.layout));
    }

    int addNode(const CutNode& node) {
        curves_.nodes.push_back(node);
        return sizeOf(curves_.nodes) - 1;
    }

    void orderAlongEdge(std::vector<EdgeHit>& hits) {
        std::vector<CutNode>& nodes = curves_.nodes;
        std::sort(hits.begin(), hits.end(), [&](const EdgeHit& p, const EdgeHit& q) {
            return nodes[p.node].t != nodes[q.node].t ? nodes[p.node].t < nodes[q.node].t
                                                      : p.stripTriangle < q.stripTriangle;
        });
        const int n = sizeOf(hits);
        const double gap = std::min(kLeastParameter, 0.5 / (n + 1));
        for (int i = 0; i < n; ++i) {
            double& t = nodes[hits[i].node].t;
            const double low =
                std::max(gap * (i + 1), i > 0 ? nodes[hits[i - 1].node].t + gap : 0.0);
            t = std::min(1 - gap * (n - i), std::max(t, low));
        }
    }

    // Positions come from the real edges and triangles, also where predicates saw them elsewhere.
    void place(CutNode& node) const {
        if (node.kind == NodeKind::edge) {
            placeOnEdge(node);
        } else if (node.kind == NodeKind::face) {
            placeOnFace(node);
        }
    }

    void placeOnEdge(CutNode& node) const {
        const auto lerp = [&](const Vec3& p, const Vec3& q) { return Vec3(p + (q - p) * node.t); };
        node.position = lerp(mesh_.position(node.a), mesh_.position(node.b));
        node.rest = lerp(mesh_.restPosition(node.a), mesh_.restPosition(node.b));
        node.velocity = lerp(mesh_.velocity(node.a), mesh_.velocity(node.b));
    }

    // In canonical order throughout: the mirrored node in the other wall of an older slit comes out
    // the same to the last bit, or the Delaunay criterion would divide the two walls differently.
    void placeOnFace(CutNode& node) const {
        SeenTriangle corners;
        look(node.a, corners);
        putInOrder(corners);
        const std::array<int, 3>& order = corners.order;
        node.weights = node.weights.cwiseMax(kLeastParameter);
        node.weights /= node.weights[order[0]] + node.weights[order[1]] + node.weights[order[2]];
        const Triangle& ids = mesh_.triangle(node.a);
        for (const int i : order) {
            node.position += node.weights[i] * mesh_.position(ids[i]);
            node.rest += node.weights[i] * mesh_.restPosition(ids[i]);
            node.velocity += node.weights[i] * mesh_.velocity(ids[i]);
        }
    }

    const StepInput& in_;
    const SurfaceMesh& mesh_;
    const Strip& strip_;
    const PredicatePositions& positions_;
    FrontProfile front_;
    std::vector<int> rungVertices_;  ///< ascending
    double drift_ = 0;               ///< predicateDrift()
    std::vector<Vec3> inFrame_;      ///< the nodes of the strip along the axes of the broad phase
    std::vector<SeenTriangle> corners_;  ///< of the entries that do not lie behind the front
    std::vector<int> cornersOf_;  ///< places there, by entry of the broad phase; -1 for others
    BroadPhase::Bins ahead_;      ///< entries that do not lie behind the front
    std::vector<int> found_;
    std::vector<std::pair<int, int>> stripVertices_;  ///< of the strip triangle in hand: corners
    std::set<int> fringe_;                            ///< empty until fringe() is asked
    CutCurves curves_;
};

}  // namespace

int CutCurves::vertexNode(const SurfaceMesh& mesh, int v, const Vec2& layout) {
    if (const int known = nodeOfVertex.find(v); known >= 0) {
        return known;
    }
    CutNode node;
    node.kind = NodeKind::vertex;
    node.a = v;
    node.layout = layout;
    node.position = mesh.position(v);
    node.rest = mesh.restPosition(v);
    node.velocity = mesh.velocity(v);
    nodes.push_back(node);
    nodeOfVertex.add(v, sizeOf(nodes) - 1);
    return sizeOf(nodes) - 1;
}

CutCurves intersect(const StepInput& in, const Strip& strip, const PredicatePositions& positions) {
    return Intersector(in, strip, positions).run();
}

}  // namespace kerf::cut
