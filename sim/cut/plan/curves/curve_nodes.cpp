#include "sim/cut/plan/curves/curve_nodes.h"

#include "sim/base/predicates.h"
#include "sim/cut/cut_types.h"

namespace kerf::cut {

namespace {

// Stands for the sign of a vertex that both triangles share.
constexpr int kShared = 9;
// Far more than what rounding does to the distance from a plane, as a share of all lengths in it.
constexpr double kApartError = 1e-13;

constexpr std::array<std::array<int, 2>, 3> kOtherCorners{{{1, 2}, {2, 0}, {0, 1}}};

ThreePoints rowsOf(const Corners& at) {
    ThreePoints rows;
    for (int axis = 0; axis < 3; ++axis) {
        rows.col(axis) << at[0][axis], at[1][axis], at[2][axis], at[2][axis];
    }
    return rows;
}

Vec2 project(const Vec3& p, int dropped) {
    return {p[(dropped + 1) % 3], p[(dropped + 2) % 3]};
}

bool hasZeroArea(const Corners& abc) {
    for (int axis = 0; axis < 3; ++axis) {
        if (orient2d(project(abc[0], axis), project(abc[1], axis), project(abc[2], axis)) != 0) {
            return false;
        }
    }
    return true;
}

// An edge in the plane of the triangle: apart by an exact test in the dominant projection, or the
// triangle has no area (then its edges carry the crossing), or degenerate.
void requireApartInPlane(const Vec3& p, const Vec3& q, const Corners& abc) {
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

/// Whether the segment pq passes through the triangle abc, from the signs of p and q against its
/// plane.
bool passesThrough(const Vec3& p, const Vec3& q, const Corners& abc, int signOfP, int signOfQ) {
    if (signOfP == 0 && signOfQ == 0) {
        requireApartInPlane(p, q, abc);
        return false;
    }
    if (signOfP == signOfQ) {
        return false;
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
        return false;
    }
    if (onEdge) {
        throw StepFailure{"degenerate: an edge meets an edge"};
    }
    if (signOfP == 0 || signOfQ == 0) {
        throw StepFailure{"degenerate: a vertex lies on a triangle"};
    }
    return true;
}

/// Signs of points against the plane of abc; nothing where all lie on one side. `shared`: which of
/// them lies in it, -1 for none.
std::optional<std::array<int, 3>> signsAgainst(const Corners& abc, const Corners& points,
                                               int shared) {
    std::array<int, 3> signs{};
    for (int i = 0; i < 3; ++i) {
        signs[i] = i == shared ? kShared : orientSign3d(abc[0], abc[1], abc[2], points[i]);
    }
    for (const int side : {1, -1}) {
        if (std::ranges::all_of(signs, [&](int x) { return x == side || x == kShared; })) {
            return std::nullopt;
        }
    }
    return signs;
}

/// `leaves`: whether the curve ends where the edge goes from the negative to the positive side.
std::optional<Crossing> crossingOf(const Corners& edges, const std::array<int, 3>& signs, int from,
                                   int to, const Corners& abc, bool leaves) {
    const Vec3& p = edges[from];
    const Vec3& q = edges[to];
    if (!passesThrough(p, q, abc, signs[from], signs[to])) {
        return std::nullopt;
    }
    const Orientation ofP = orient3d(abc[0], abc[1], abc[2], p);
    const double fromP = std::fabs(ofP.value);
    const double fromQ = std::fabs(orient3d(abc[0], abc[1], abc[2], q).value);
    return Crossing{from, to, (ofP.sign < 0) == leaves, fromP / (fromP + fromQ),
                    weightsOfCrossing(p, q, abc)};
}

// Curve nodes keep this distance (as parameter or weight) from the ends of their edge and the
// border of their triangle, so that positions of neighbours in one edge stay distinct.
constexpr double kLeastParameter = 1e-9;
// A point that lies no farther outside of a triangle, as a weight, is on its border; and one no
// farther from the end of an edge, as a share, is at that end.
constexpr double kBeside = 1e-3;

}  // namespace

SeenTriangle::SeenTriangle(const Triangle& vertices, const Corners& corners)
    : ids(vertices), at(corners), points(rowsOf(at)), sum(at[0] + at[1] + at[2]) {}

void SeenTriangle::putInOrder() {
    if (std::exchange(ordered, true)) {
        return;
    }
    const auto sortPair = [this](int u, int v) {
        int& first = order[u];
        int& second = order[v];
        if (comesBefore(at[second], ids[second], at[first], ids[first])) {
            std::swap(first, second);
            parity = -parity;
        }
    };
    sortPair(0, 1);
    sortPair(1, 2);
    sortPair(0, 1);
}

StripTriangle::StripTriangle(int which, const Triangle& nodes, const Corners& corners)
    : index(which),
      ids(nodes),
      at(corners),
      points(rowsOf(at)),
      sum(at[0] + at[1] + at[2]),
      reach(points.cwiseAbs().maxCoeff()) {}

bool areApart(const TrianglePair& pair) {
    const auto& [mesh, strip, shared] = pair;
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

std::optional<PairSigns> signsOf(const TrianglePair& pair) {
    const auto& [mesh, strip, shared] = pair;
    const auto ofMesh = signsAgainst(strip.at, mesh.at, shared.meshCorner);
    const auto ofStrip =
        ofMesh ? signsAgainst(mesh.inOrder(), strip.at, shared.stripCorner) : std::nullopt;
    return ofStrip ? std::optional(PairSigns{*ofMesh, *ofStrip}) : std::nullopt;
}

// Along a counter-clockwise half-edge from - to + the curve leaves the triangle.
std::optional<Crossing> meshEdgeCrossing(const TrianglePair& pair, const PairSigns& signs,
                                         int corner) {
    const SeenTriangle& mesh = pair.mesh;
    const int next = (corner + 1) % 3;
    const bool turned =
        comesBefore(mesh.at[next], mesh.ids[next], mesh.at[corner], mesh.ids[corner]);
    return crossingOf(mesh.at, signs.mesh, turned ? next : corner, turned ? corner : next,
                      pair.strip.at, !turned);
}

// Along a counter-clockwise half-edge of the strip from outside to inside the curve leaves the
// triangle.
std::optional<Crossing> stripEdgeCrossing(const TrianglePair& pair, const PairSigns& signs,
                                          int corner) {
    const StripTriangle& strip = pair.strip;
    const int next = (corner + 1) % 3;
    const bool turned = strip.ids[corner] > strip.ids[next];
    return crossingOf(strip.at, signs.strip, turned ? next : corner, turned ? corner : next,
                      pair.mesh.inOrder(), turned == (pair.mesh.parity > 0));
}

Vec3 weightsOfCrossing(const Vec3& p, const Vec3& q, const Corners& abc) {
    Vec3 beside;
    for (int i = 0; i < 3; ++i) {
        beside[i] = orient3d(p, q, abc[i], abc[(i + 1) % 3]).value;
    }
    const double sum = beside[0] + beside[1] + beside[2];
    return Vec3(beside[1], beside[2], beside[0]) / sum;
}

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
