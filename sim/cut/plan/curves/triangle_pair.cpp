#include "sim/cut/plan/curves/triangle_pair.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace kerf::cut
