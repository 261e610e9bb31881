#include "sim/cut/cleanup/deviation.h"

#include <algorithm>
#include <limits>

#include "sim/mesh/closest_point.h"

namespace kerf::cut {

namespace {

constexpr double kFar = std::numeric_limits<double>::max();

double distanceToTriangle(const Vec3& p, const Corners& t) {
    const Vec3 w = closestWeights(p, t[0], t[1], t[2]);
    const double distance = (p - (w[0] * t[0] + w[1] * t[1] + w[2] * t[2])).norm();
    // Triangles without area have no weights.
    return distance >= 0 ? distance
                         : std::min({(p - t[0]).norm(), (p - t[1]).norm(), (p - t[2]).norm()});
}

double distanceToAny(const Vec3& p, const std::vector<Corners>& triangles) {
    double least = kFar;
    for (const Corners& t : triangles) {
        least = std::min(least, distanceToTriangle(p, t));
    }
    return least;
}

double distanceToFan(const Vec3& p, const Vec3& center, const std::vector<Vec3>& ends) {
    double least = kFar;
    for (const Vec3& end : ends) {
        least = std::min(least, distanceToSegment(p, center, end));
    }
    return least;
}

struct RingShape {
    std::vector<Corners> before;
    std::vector<Corners> after;
};

RingShape shapeOf(const SurfaceMesh& mesh, const OneRing& ring, bool ofSkin) {
    RingShape shape;
    for (const int t : ring.before) {
        if (!ofSkin || mesh.kind(t) == SurfaceKind::skin) {
            shape.before.push_back(cornersOf(mesh, t));
        }
    }
    for (const RingTriangle& t : ring.after) {
        if (!ofSkin || mesh.kind(t.slot) == SurfaceKind::skin) {
            shape.after.push_back(cornersAfter(mesh, ring, t));
        }
    }
    return shape;
}

double skinDeviation(const SurfaceMesh& mesh, const OneRing& ring) {
    const RingShape skin = shapeOf(mesh, ring, true);
    if (skin.before.empty()) {
        return 0;
    }
    double most = std::max(distanceToAny(mesh.position(ring.vertex), skin.after),
                           distanceToAny(ring.position, skin.before));
    for (const int v : ring.merged) {
        most = std::max(most, distanceToAny(mesh.position(v), skin.after));
    }
    for (const Corners& t : skin.after) {
        most = std::max(most, distanceToAny((t[0] + t[1] + t[2]) / 3, skin.before));
    }
    return most;
}

double wallDeviation(const SurfaceMesh& mesh, const OneRing& ring) {
    const RingShape walls = shapeOf(mesh, ring, false);
    double most = distanceToAny(ring.position, walls.before);
    for (const int v : ring.merged) {
        most = std::max(most, distanceToAny(mesh.position(v), walls.after));
    }
    return most;
}

/// Where the rim goes on from a copy, leaving out the way to `except`.
std::vector<Vec3> rimEnds(const SurfaceMesh& mesh, const SharedStar& star, int vertex, int except) {
    std::vector<Vec3> ends;
    mesh.forEachOutgoing(vertex, [&](int h) {
        const int target = mesh.firstCopy(mesh.target(h));
        if (target != except && star.edgeTo(target)->type() == SharedEdgeType::rim) {
            ends.push_back(mesh.position(mesh.target(h)));
        }
    });
    return ends;
}

double rimDeviation(const SurfaceMesh& mesh, const SharedStar& from, const SharedStar& to,
                    const OneRing& ring) {
    const Vec3& place = mesh.position(ring.vertex);
    const SharedEdge* between = from.edgeTo(to.point);
    const bool along = between != nullptr && between->type() == SharedEdgeType::rim;
    std::vector<Vec3> ends = ring.joins ? rimEnds(mesh, from, ring.vertex, to.point)
                                        : rimEnds(mesh, to, ring.vertex, from.point);
    double most = distanceToFan(ring.position, place, ends);
    std::vector<Vec3> gone;
    if (along) {
        for (const int v : ring.merged) {
            const std::vector<Vec3> further = rimEnds(mesh, from, v, to.point);
            most = std::min({most, distanceToFan(ring.position, mesh.position(v), further),
                             distanceToSegment(ring.position, place, mesh.position(v))});
            ends.insert(ends.end(), further.begin(), further.end());
            gone.push_back(mesh.position(v));
        }
    }
    if (ends.empty()) {
        return along ? (ring.position - place).norm() : 0;
    }
    most = std::max(most, distanceToFan(place, ring.position, ends));
    for (const Vec3& v : gone) {
        most = std::max(most, distanceToFan(v, ring.position, ends));
    }
    return most;
}

}  // namespace

double deviationOf(const SurfaceMesh& mesh, const SharedStar& from, const SharedStar& to,
                   const std::vector<OneRing>& rings) {
    const bool wallsOnly = isWallOnly(mesh, rings);
    double most = 0;
    for (const OneRing& ring : rings) {
        most = std::max({most, wallsOnly ? wallDeviation(mesh, ring) : skinDeviation(mesh, ring),
                         rimDeviation(mesh, from, to, ring)});
    }
    return most;
}

}  // namespace kerf::cut
