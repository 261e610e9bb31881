#include "sim/cut/cleanup/acceptance.h"

namespace kerf::cut {

namespace {

// Cosines of the largest turns.
constexpr double kTurnFromSector = 0.35;
constexpr double kTurnOfTriangle = 0.6;
constexpr double kTurnOfSliver = 0.1;
// Twice the area (share of h^2) below which a direction says nothing.
constexpr double kSliverArea = 1e-4;
// Triangles thinner than this share of h look anywhere: crowds of points around an exact hit.
constexpr double kFlat = 1e-5;
// How much better the worst triangle must be where their number stays.
constexpr double kClearlyBetter = 1.2;
constexpr double kNotWorse = 0.999;

bool looksAlong(const Vec3& a, const Vec3& b, double cosine) {
    return a.dot(b) >= cosine * a.norm() * b.norm();
}

/// Over the longest edge.
double heightOf(const Corners& corners) {
    const double square = longestEdgeSquare(corners);
    return square > 0 ? areaNormal(corners).norm() / std::sqrt(square) : 0;
}

bool keepsOrientation(const SurfaceMesh& mesh, double h, const OneRing& ring,
                      const RingTriangle& t) {
    const Vec3 now = areaNormal(cornersAfter(mesh, ring, t));
    const Vec3 before = areaNormal(cornersOf(mesh, t.slot));
    const double sliver = kSliverArea * h * h;
    if (heightOf(cornersAfter(mesh, ring, t)) < kFlat * h) {
        return true;
    }
    const bool sectorTells = t.reference.norm() > sliver;
    const bool triangleTells = before.norm() > sliver;
    if (!sectorTells && !triangleTells) {
        return looksAlong(now, t.reference, kTurnOfSliver);
    }
    return (!sectorTells || looksAlong(now, t.reference, kTurnFromSector)) &&
           (!triangleTells || looksAlong(now, before, kTurnOfTriangle));
}

}  // namespace

double triangleScore(const Corners& corners, double goodEdge) {
    const double longest = longestEdgeSquare(corners);
    if (longest <= 0) {
        return 0;
    }
    const double shortest =
        std::min({(corners[1] - corners[0]).squaredNorm(), (corners[2] - corners[1]).squaredNorm(),
                  (corners[0] - corners[2]).squaredNorm()});
    const double quality = areaNormal(corners).norm() / longest;
    return std::min({1.0, quality / kGoodQuality, std::sqrt(shortest) / goodEdge});
}

double triangleScore(const SurfaceMesh& mesh, int triangle, double goodEdge) {
    return triangleScore(cornersOf(mesh, triangle), goodEdge);
}

void Scores::add(double score) {
    worst = std::min(worst, score);
    bad += score < 1;
}

Scores scoresBefore(const Workspace& workspace, const std::vector<OneRing>& rings) {
    Scores scores;
    for (const OneRing& ring : rings) {
        for (const int t : ring.before) {
            scores.add(triangleScore(workspace.mesh, t, workspace.goodEdgeLength()));
        }
    }
    return scores;
}

Scores scoresAfter(const Workspace& workspace, const std::vector<OneRing>& rings) {
    Scores scores;
    for (const OneRing& ring : rings) {
        for (const RingTriangle& t : ring.after) {
            scores.add(
                triangleScore(cornersAfter(workspace.mesh, ring, t), workspace.goodEdgeLength()));
        }
    }
    return scores;
}

bool improves(const Scores& before, const Scores& after) {
    const bool fewer = after.bad < before.bad && after.worst >= kNotWorse * before.worst;
    return fewer || after.bad == 0 || after.worst > kClearlyBetter * before.worst + 1e-15;
}

bool keepsOrientation(const Workspace& workspace, const std::vector<OneRing>& rings) {
    return std::all_of(rings.begin(), rings.end(), [&](const OneRing& ring) {
        return std::all_of(ring.after.begin(), ring.after.end(), [&](const RingTriangle& t) {
            return keepsOrientation(workspace.mesh, workspace.edgeLength(), ring, t);
        });
    });
}

}  // namespace kerf::cut
