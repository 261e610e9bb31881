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

struct PatchShape {
    std::vector<Corners> before;
    std::vector<Corners> after;
};

PatchShape shapeOf(const SurfaceMesh& mesh, const Patch& patch, bool ofSkin) {
    PatchShape shape;
    for (const int t : patch.before) {
        if (!ofSkin || mesh.kind(t) == SurfaceKind::skin) {
            shape.before.push_back(cornersOf(mesh, t));
        }
    }
    for (const PatchTriangle& t : patch.after) {
        if (!ofSkin || mesh.kind(t.slot) == SurfaceKind::skin) {
            shape.after.push_back(cornersAfter(mesh, patch, t));
        }
    }
    return shape;
}

double skinDeviation(const SurfaceMesh& mesh, const Patch& patch) {
    const PatchShape skin = shapeOf(mesh, patch, true);
    if (skin.before.empty()) {
        return 0;
    }
    double most = std::max(distanceToAny(mesh.position(patch.vertex), skin.after),
                           distanceToAny(patch.position, skin.before));
    for (const int v : patch.merged) {
        most = std::max(most, distanceToAny(mesh.position(v), skin.after));
    }
    for (const Corners& t : skin.after) {
        most = std::max(most, distanceToAny((t[0] + t[1] + t[2]) / 3, skin.before));
    }
    return most;
}

double wallDeviation(const SurfaceMesh& mesh, const Patch& patch) {
    const PatchShape walls = shapeOf(mesh, patch, false);
    double most = distanceToAny(patch.position, walls.before);
    for (const int v : patch.merged) {
        most = std::max(most, distanceToAny(mesh.position(v), walls.after));
    }
    return most;
}

/// Where the rim goes on from a copy, leaving out the way to `except`.
std::vector<Vec3> rimEnds(const SurfaceMesh& mesh, const MaterialStar& star, int vertex,
                          int except) {
    std::vector<Vec3> ends;
    mesh.forEachOutgoing(vertex, [&](int h) {
        const int target = mesh.materialPoint(mesh.target(h));
        if (target != except && star.edgeTo(target)->type() == MaterialEdgeType::rim) {
            ends.push_back(mesh.position(mesh.target(h)));
        }
    });
    return ends;
}

double rimDeviation(const SurfaceMesh& mesh, const MaterialStar& from, const MaterialStar& to,
                    const Patch& patch) {
    const Vec3& place = mesh.position(patch.vertex);
    const MaterialEdge* between = from.edgeTo(to.point);
    const bool along = between != nullptr && between->type() == MaterialEdgeType::rim;
    std::vector<Vec3> ends = patch.joins ? rimEnds(mesh, from, patch.vertex, to.point)
                                         : rimEnds(mesh, to, patch.vertex, from.point);
    double most = distanceToFan(patch.position, place, ends);
    std::vector<Vec3> gone;
    if (along) {
        for (const int v : patch.merged) {
            const std::vector<Vec3> further = rimEnds(mesh, from, v, to.point);
            most = std::min({most, distanceToFan(patch.position, mesh.position(v), further),
                             distanceToSegment(patch.position, place, mesh.position(v))});
            ends.insert(ends.end(), further.begin(), further.end());
            gone.push_back(mesh.position(v));
        }
    }
    if (ends.empty()) {
        return along ? (patch.position - place).norm() : 0;
    }
    most = std::max(most, distanceToFan(place, patch.position, ends));
    for (const Vec3& v : gone) {
        most = std::max(most, distanceToFan(v, patch.position, ends));
    }
    return most;
}

}  // namespace

double deviationOf(const SurfaceMesh& mesh, const MaterialStar& from, const MaterialStar& to,
                   const std::vector<Patch>& patches) {
    const bool wallsOnly = isWallOnly(mesh, patches);
    double most = 0;
    for (const Patch& patch : patches) {
        most = std::max({most, wallsOnly ? wallDeviation(mesh, patch) : skinDeviation(mesh, patch),
                         rimDeviation(mesh, from, to, patch)});
    }
    return most;
}

}  // namespace kerf::cut
