#include "sim/cut/cleanup/slide.h"

#include "sim/cut/cleanup/acceptance.h"
#include "sim/cut/cleanup/deviation.h"
#include "sim/cut/cleanup/placement.h"
#include "sim/cut/cleanup/self_piercing.h"
#include "sim/mesh/deformation_field.h"

namespace kerf::cut {

namespace {

// How far beyond good a slide aims, so that rounding does not undo it.
constexpr double kBeyondQuality = 1.3;
constexpr double kBeyondEdge = 1.2;
// Least share of a wanted direction that keeps volumes.
constexpr double kLeastPush = 0.2;
constexpr double kLeastStretch = 0.3;
// Edges too short to tell a direction (shares of h).
constexpr double kNoBase = 1e-9;
constexpr double kNoEdge = 1e-6;
constexpr double kRestReach = 4;  // times the way that rest edges allow

class ApexSlide {
  public:
    ApexSlide(Workspace& workspace, int vertex)
        : workspace_(workspace), mesh_(workspace.mesh), star_(starOf(mesh_, vertex)) {
        for (const int v : star_.copies) {
            gradients_.push_back(volumeGradient(mesh_, VertexPositions::current(mesh_), v));
            restGradients_.push_back(volumeGradient(mesh_, VertexPositions::atRest(mesh_), v));
        }
    }

    /// Moves all copies by `length` along `direction` (a unit vector), as far as volumes let it.
    bool push(const Vec3& direction, double length, double leastShare) {
        if (workspace_.isKept(star_.copies)) {
            return false;
        }
        const Vec3 way = projectOnConstantVolume(gradients_, direction);
        const double share = way.dot(direction);
        return share >= leastShare &&
               (moveBy(way * (length / share)) || moveBy(way * (0.5 * length / share)));
    }

    /// Area vector of the sector that holds a triangle.
    Vec3 sectorOf(int triangle) const {
        for (const int v : star_.copies) {
            for (const RingTriangle& t : ringOfMove(mesh_, star_, v).after) {
                if (t.slot == triangle) {
                    return t.reference;
                }
            }
        }
        return Vec3::Zero();
    }

  private:
    bool moveBy(const Vec3& way) {
        const std::vector<OneRing> rings = ringsMovedBy(way);
        const VolumeDefect defect = volumeDefect(mesh_, rings);
        if (workspace_.touchesRung(rings) ||
            !improves(scoresBefore(workspace_, rings), scoresAfter(workspace_, rings)) ||
            !keepsOrientation(workspace_, rings) ||
            !workspace_.allows(defect, isWallOnly(mesh_, rings))) {
            return false;
        }
        const double deviation =
            deviationOf(mesh_, star_, star_, rings) + workspace_.deviationAt(star_.copies);
        if (deviation > workspace_.mostDeviation() || addsPiercings(mesh_, rings) ||
            unfacedDeviation(workspace_, rings) > kMostUnfaced * workspace_.edgeLength()) {
            return false;
        }
        for (const OneRing& ring : rings) {
            workspace_.moveVertex(ring);
        }
        workspace_.setDeviation(star_.copies, deviation);
        workspace_.spend(defect);
        return true;
    }

    std::vector<OneRing> ringsMovedBy(const Vec3& way) const {
        const Vec3 restWay = restWayOf(way);
        const Vec3 velocityWay = velocityWayOf(way);
        std::vector<OneRing> rings;
        for (const int v : star_.copies) {
            rings.push_back(ringOfMove(mesh_, star_, v));
            rings.back().position = mesh_.position(v) + way;
            rings.back().rest = mesh_.restPosition(v) + restWay;
            rings.back().velocity = mesh_.velocity(v) + velocityWay;
        }
        return rings;
    }

    Vec3 velocityWayOf(const Vec3& way) const {
        LinearField velocity;
        for (const int v : star_.copies) {
            mesh_.forEachOutgoing(v, [&](int h) {
                const int u = mesh_.target(h);
                velocity.add(mesh_.position(u) - mesh_.position(v),
                             mesh_.velocity(u) - mesh_.velocity(v));
            });
        }
        return velocity.along(way);
    }

    bool liesAtRest() const {
        const auto isAtRest = [&](int v) { return mesh_.restPosition(v) == mesh_.position(v); };
        return std::ranges::all_of(star_.copies, [&](int v) {
            bool all = isAtRest(v);
            mesh_.forEachOutgoing(v, [&](int h) { all = all && isAtRest(mesh_.target(h)); });
            return all;
        });
    }

    // As the rest shape goes along, then as its volumes allow. What lies at rest stays so, to the
    // last bit.
    Vec3 restWayOf(const Vec3& way) const {
        if (liesAtRest()) {
            return way;
        }
        DeformationField field(VertexPositions::current(mesh_), VertexPositions::atRest(mesh_));
        for (const int v : star_.copies) {
            mesh_.forEachOutgoing(v, [&](int h) { field.add(mesh_.triangle(h / 3)); });
        }
        const Vec3 restWay = projectOnConstantVolume(restGradients_, field.along(way));
        const double most = kRestReach * way.norm() * restStretch(mesh_, star_.copies[0]);
        return restWay.norm() > most ? Vec3(restWay * (most / restWay.norm())) : restWay;
    }

    Workspace& workspace_;
    const SurfaceMesh& mesh_;
    SharedStar star_;
    std::vector<Vec3> gradients_;
    std::vector<Vec3> restGradients_;
};

bool pushApexFrom(Workspace& workspace, int base) {
    const SurfaceMesh& mesh = workspace.mesh;
    const double h = workspace.edgeLength();
    const int apex = mesh.apex(base);
    const Vec3& a = mesh.position(mesh.origin(base));
    const Vec3 ab = mesh.position(mesh.target(base)) - a;
    const double length = ab.norm();
    if (length < kNoBase * h) {
        return false;
    }
    const Vec3 fromA = mesh.position(apex) - a;
    const double height = (fromA - ab * (fromA.dot(ab) / (length * length))).norm();
    const double wanted =
        std::max(kBeyondQuality * kGoodQuality * length, kBeyondEdge * kGoodEdge * h);
    if (height >= wanted) {
        return false;
    }
    ApexSlide slide(workspace, apex);
    const Vec3 direction = slide.sectorOf(base / 3).cross(ab);
    return direction.norm() > 0 && slide.push(direction.normalized(), wanted - height, kLeastPush);
}

bool pushApart(Workspace& workspace, int moving, int staying) {
    const SurfaceMesh& mesh = workspace.mesh;
    const double h = workspace.edgeLength();
    const Vec3 edge = mesh.position(moving) - mesh.position(staying);
    const double length = edge.norm();
    if (length < kNoEdge * h || length > kGoodEdge * h) {
        return false;
    }
    return ApexSlide(workspace, moving)
        .push(edge / length, kBeyondEdge * kGoodEdge * h - length, kLeastStretch);
}

}  // namespace

bool slideVertex(Workspace& workspace, int triangle) {
    const SurfaceMesh& mesh = workspace.mesh;
    const std::array<int, 3> edges = edgesByLength(mesh, triangle);
    const int u = mesh.origin(edges[0]);
    const int v = mesh.target(edges[0]);
    return pushApexFrom(workspace, edges[2]) || pushApexFrom(workspace, edges[1]) ||
           pushApexFrom(workspace, edges[0]) || pushApart(workspace, u, v) ||
           pushApart(workspace, v, u);
}

}  // namespace kerf::cut
