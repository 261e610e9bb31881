#include "sim/cut/cleanup/deviation.h"

#include "sim/mesh/deformation_field.h"
#include "sim/mesh/triangle.h"

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

/// The walls of a ring that have a label, at rest.
RingShape wallsAtRest(const Workspace& workspace, const OneRing& ring, int label) {
    const SurfaceMesh& mesh = workspace.mesh;
    const VertexPositions rest =
        workspace.judgesAtRest() ? VertexPositions::current(mesh) : VertexPositions::atRest(mesh);
    RingShape shape;
    for (const int t : ring.before) {
        if (mesh.wallLabel(t) == label) {
            const Triangle& c = mesh.triangle(t);
            shape.before.push_back({rest[c[0]], rest[c[1]], rest[c[2]]});
        }
    }
    const Vec3& place = workspace.judgesAtRest() ? ring.position : ring.rest;
    const auto after = [&](int v) -> const Vec3& { return v == ring.vertex ? place : rest[v]; };
    for (const RingTriangle& t : ring.after) {
        if (mesh.wallLabel(t.slot) == label) {
            shape.after.push_back({after(t.corners[0]), after(t.corners[1]), after(t.corners[2])});
        }
    }
    return shape;
}

/// The walls that the rings meet, by label: their corners as points of the uncut body.
std::map<int, std::set<int>> pointsOfWalls(const SurfaceMesh& mesh,
                                           const std::vector<OneRing>& rings) {
    std::map<int, std::set<int>> points;
    for (const OneRing& ring : rings) {
        for (const int t : ring.before) {
            if (mesh.wallLabel(t) >= 0) {
                for (const int v : mesh.triangle(t)) {
                    points[mesh.wallLabel(t)].insert(mesh.firstCopy(v));
                }
            }
        }
    }
    return points;
}

}  // namespace

double unfacedDeviation(const Workspace& workspace, const std::vector<OneRing>& rings) {
    double most = 0;
    const std::map<int, std::set<int>> walls = pointsOfWalls(workspace.mesh, rings);
    for (const auto& [label, points] : walls) {
        const auto facing = walls.find(label ^ 1);
        if (facing != walls.end() && facing->second == points) {
            continue;
        }
        for (const OneRing& ring : rings) {
            const RingShape shape = wallsAtRest(workspace, ring, label);
            for (const auto& [from, to] :
                 {std::pair(&shape.before, &shape.after), std::pair(&shape.after, &shape.before)}) {
                for (const Corners& t : *from) {
                    for (const Vec3& corner : t) {
                        most = std::max(most, to->empty() ? 0.0 : distanceToAny(corner, *to));
                    }
                }
            }
        }
    }
    return most;
}

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
