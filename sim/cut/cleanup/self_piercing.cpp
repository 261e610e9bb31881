#include "sim/cut/cleanup/self_piercing.h"

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/base/predicates.h"
#include "sim/cut/exact/piercing.h"
#include "sim/cut/wall_copies.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Stands for the copies of a vertex that an operation moves or merges: all of them end at one
// place.
constexpr int kMovedPoint = -2;

// Sine of the angle between two triangles at an edge below which they lie on each other.
constexpr double kFoldedFlat = 1e-3;

// Share of the longer edge: triangles that come so near to each other touch.
constexpr double kTouching = 1e-9;
// Of two edges: what lies so near to their ends is no crossing.
constexpr double kEndOfEdge = 1e-6;

/// A triangle at its place; points tell which corners are one.
struct Placed {
    Triangle vertices;
    Triangle points;
    Corners corners;
    int stroke;      ///< -1 on skin
    Vec3 normal;     ///< twice the area long
    double longest;  ///< edge
    Bounds bounds;
};

Placed placed(const Triangle& vertices, const Triangle& points, const Corners& corners,
              int stroke) {
    return {vertices,      points, corners, stroke, areaNormal(corners), longestEdge(corners),
            boxOf(corners)};
}

Triangle pointsOf(const SurfaceMesh& mesh, const Triangle& corners) {
    return {mesh.firstCopy(corners[0]), mesh.firstCopy(corners[1]), mesh.firstCopy(corners[2])};
}

/// With other corners than it has.
Placed placed(const SurfaceMesh& mesh, int slot, const Triangle& corners) {
    return placed(corners, pointsOf(mesh, corners),
                  {mesh.position(corners[0]), mesh.position(corners[1]), mesh.position(corners[2])},
                  strokeOf(mesh, slot));
}

Placed placed(const SurfaceMesh& mesh, int slot) {
    return placed(mesh, slot, mesh.triangle(slot));
}

bool has(const Triangle& triangle, int point) {
    return std::ranges::find(triangle, point) != triangle.end();
}

/// Corners lie on both sides of the plane of the other, as far as doubles tell.
bool straddles(const Placed& a, const Placed& plane) {
    bool above = false;
    bool below = false;
    const auto& [p, q, r] = plane.corners;
    for (int i = 0; i < 3; ++i) {
        const int side =
            has(plane.points, a.points[i]) ? 0 : estimate3d(p, q, r, a.corners[i]).sign();
        above = above || side > 0;
        below = below || side < 0;
    }
    return above && below;
}

bool anyEdgePierces(const Placed& edges, const Placed& triangle) {
    if (!straddles(edges, triangle)) {
        return false;
    }
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        if (!has(triangle.points, edges.points[i]) && !has(triangle.points, edges.points[k]) &&
            pierces(edges.corners[i], edges.corners[k], triangle.corners)) {
            return true;
        }
    }
    return false;
}

/// They share an edge and lie on each other with nothing in between, other than both walls at the
/// end of a slit do, whose third corners are one.
bool foldedFlat(const Placed& a, const Placed& b) {
    const auto isShared = [&](int v) { return has(b.vertices, v); };
    const auto isCommon = [&](int point) { return has(b.points, point); };
    if (std::ranges::count_if(a.vertices, isShared) != 2 ||
        std::ranges::all_of(a.points, isCommon)) {
        return false;
    }
    const Vec3& n = a.normal;
    const Vec3& m = b.normal;
    return n.dot(m) < 0 && n.cross(m).norm() < kFoldedFlat * n.norm() * m.norm();
}

/// All corners of a that b does not have lie on one side of the plane of b, farther than `distance`
/// from it.
bool isAside(const Placed& a, const Placed& b, double distance) {
    const double least = distance * distance * b.normal.squaredNorm();
    bool above = true;
    bool below = true;
    for (int i = 0; i < 3; ++i) {
        if (!has(b.points, a.points[i])) {
            const double height = b.normal.dot(a.corners[i] - b.corners[0]);
            const bool near = height * height <= least;
            above = above && height > 0 && !near;
            below = below && height < 0 && !near;
        }
    }
    return above || below;
}

/// A corner of a lies on b, inside or on an edge.
bool cornerTouches(const Placed& a, const Placed& b, double distance) {
    for (int i = 0; i < 3; ++i) {
        if (has(b.points, a.points[i])) {
            continue;
        }
        const Vec3& p = a.corners[i];
        const auto& [q, r, s] = b.corners;
        const Vec3 w = closestWeights(p, q, r, s);
        const Vec3 nearest = w[0] * q + w[1] * r + w[2] * s;
        const bool atCorner = std::ranges::any_of(
            b.corners, [&](const Vec3& corner) { return (corner - p).norm() < 2 * distance; });
        if ((nearest - p).norm() < distance && !atCorner) {
            return true;
        }
    }
    return false;
}

/// pq and rs come within `distance` of each other, away from their ends.
bool edgesCross(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, double distance) {
    const Vec3 u = q - p;
    const Vec3 v = s - r;
    const Vec3 across = u.cross(v);
    const double square = across.squaredNorm();
    if (square == 0 || std::fabs(across.dot(r - p)) > distance * std::sqrt(square)) {
        return false;
    }
    const auto isInside = [](double t) { return t > kEndOfEdge && t < 1 - kEndOfEdge; };
    return isInside((r - p).cross(v).dot(across) / square) &&
           isInside((r - p).cross(u).dot(across) / square);
}

bool anyEdgesCross(const Placed& a, const Placed& b, double distance) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3;
            const bool noCommonEnd = a.points[i] != b.points[k] && a.points[i] != b.points[l] &&
                                     a.points[j] != b.points[k] && a.points[j] != b.points[l];
            if (noCommonEnd &&
                edgesCross(a.corners[i], a.corners[j], b.corners[k], b.corners[l], distance)) {
                return true;
            }
        }
    }
    return false;
}

/// Surfaces of different cuts, or a cut and the skin, touch elsewhere than in common points: a
/// chord of a wall lies in a flat piece of the other, and passes through it once the cut opens.
bool touch(const Placed& a, const Placed& b) {
    if (a.stroke == b.stroke) {
        return false;
    }
    const double distance = kTouching * std::max(a.longest, b.longest);
    return !isAside(a, b, distance) && !isAside(b, a, distance) &&
           (anyEdgesCross(a, b, distance) || cornerTouches(a, b, distance) ||
            cornerTouches(b, a, distance));
}

bool intersect(const Placed& a, const Placed& b) {
    return a.bounds.overlaps(b.bounds) &&
           (anyEdgePierces(a, b) || anyEdgePierces(b, a) || foldedFlat(a, b) || touch(a, b));
}

/// Pairs among `some`, and of these with `others`.
int intersections(const std::vector<Placed>& some, const std::vector<Placed>& others) {
    int count = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        for (std::size_t k = i + 1; k < some.size(); ++k) {
            count += intersect(some[i], some[k]);
        }
        for (const Placed& other : others) {
            count += intersect(some[i], other);
        }
    }
    return count;
}

/// What an operation takes away and what it puts there.
struct Exchange {
    std::vector<int> slots;     ///< of what it takes away
    std::vector<int> vertices;  ///< of what it puts there
    std::vector<Placed> after;
};

/// Triangles that share a vertex with the new ones and stay.
std::vector<Placed> surroundings(const SurfaceMesh& mesh, Exchange& exchange) {
    sortUnique(exchange.vertices);
    sortUnique(exchange.slots);
    std::vector<int> around;
    for (const int v : exchange.vertices) {
        mesh.forEachOutgoing(v, [&](int h) {
            if (!std::ranges::binary_search(exchange.slots, h / 3)) {
                around.push_back(h / 3);
            }
        });
    }
    sortUnique(around);
    return mapped(around, [&](int t) { return placed(mesh, t); });
}

int piercingsBefore(const SurfaceMesh& mesh, const Exchange& exchange,
                    const std::vector<Placed>& around) {
    return intersections(mapped(exchange.slots, [&](int t) { return placed(mesh, t); }), around);
}

bool addsPiercings(const SurfaceMesh& mesh, Exchange exchange) {
    const std::vector<Placed> around = surroundings(mesh, exchange);
    const int after = intersections(exchange.after, around);
    return after > 0 && after > piercingsBefore(mesh, exchange, around);
}

std::vector<int> movedPoints(const SurfaceMesh& mesh, const std::vector<OneRing>& rings) {
    std::vector<int> points;
    for (const OneRing& ring : rings) {
        points.push_back(mesh.firstCopy(ring.vertex));
        for (const int v : ring.merged) {
            points.push_back(mesh.firstCopy(v));
        }
    }
    sortUnique(points);
    return points;
}

Exchange exchangeOf(const SurfaceMesh& mesh, const std::vector<OneRing>& rings) {
    const std::vector<int> moved = movedPoints(mesh, rings);
    Exchange exchange;
    for (const OneRing& ring : rings) {
        exchange.slots.insert(exchange.slots.end(), ring.before.begin(), ring.before.end());
        for (const RingTriangle& t : ring.after) {
            exchange.vertices.insert(exchange.vertices.end(), t.corners.begin(), t.corners.end());
            Triangle points = pointsOf(mesh, t.corners);
            for (int& point : points) {
                point = std::ranges::binary_search(moved, point) ? kMovedPoint : point;
            }
            exchange.after.push_back(
                placed(t.corners, points, cornersAfter(mesh, ring, t), strokeOf(mesh, t.slot)));
        }
    }
    return exchange;
}

Exchange exchangeOf(const SurfaceMesh& mesh, const ChangedTriangles& changed) {
    Exchange exchange;
    for (const auto& [slot, corners] : changed) {
        exchange.slots.push_back(slot);
        exchange.vertices.insert(exchange.vertices.end(), corners.begin(), corners.end());
        exchange.after.push_back(placed(mesh, slot, corners));
    }
    return exchange;
}

}  // namespace

bool addsPiercings(const SurfaceMesh& mesh, const std::vector<OneRing>& rings) {
    return addsPiercings(mesh, exchangeOf(mesh, rings));
}

bool addsPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed) {
    return addsPiercings(mesh, exchangeOf(mesh, changed));
}

bool removesPiercings(const SurfaceMesh& mesh, const ChangedTriangles& changed) {
    Exchange exchange = exchangeOf(mesh, changed);
    const std::vector<Placed> around = surroundings(mesh, exchange);
    return intersections(exchange.after, around) < piercingsBefore(mesh, exchange, around);
}

std::vector<int> piercedNeighbours(const SurfaceMesh& mesh, int t) {
    const Placed own = placed(mesh, t);
    std::vector<int> pierced;
    for (const int v : mesh.triangle(t)) {
        mesh.forEachOutgoing(v, [&](int h) {
            if (h / 3 != t && intersect(own, placed(mesh, h / 3))) {
                pierced.push_back(h / 3);
            }
        });
    }
    sortUnique(pierced);
    return pierced;
}

}  // namespace kerf::cut
