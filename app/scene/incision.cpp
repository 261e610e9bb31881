#include "app/scene/incision.h"

#include <Eigen/Geometry>

#include "sim/mesh/triangle.h"

namespace kerf::app {
namespace {

constexpr double kHook = 0.12;         // of the cut's length
constexpr double kLip = 0.2;           // that a hand takes of a lip, of the cut's length
constexpr double kPiece = 0.3;         // that a hand takes of a piece, of its diagonal
constexpr double kFewTriangles = 1.5;  // the least that a hand or hook reaches, in edge lengths

constexpr double kFar = std::numeric_limits<double>::max();

/// An edge between skin and the wall of a cut.
struct RimEdge {
    int half = -1;   ///< the half-edge of the skin's triangle
    int label = -1;  ///< of the wall (see SurfaceMesh::wallLabel)
};

std::vector<RimEdge> rimOf(const SurfaceMesh& mesh) {
    std::vector<RimEdge> rim;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.present(t) || mesh.kind(t) != SurfaceKind::skin) {
            continue;
        }
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            const int across = SurfaceMesh::triangleOf(mesh.twin(h));
            if (mesh.present(across) && mesh.kind(across) == SurfaceKind::wall) {
                rim.push_back({h, mesh.wallLabel(across)});
            }
        }
    }
    return rim;
}

/// Where an edge lies in the body as it is.
struct Placed {
    Placed(const SurfaceMesh& mesh, int half)
        : from(mesh.position(mesh.origin(half))),
          to(mesh.position(mesh.target(half))),
          corners(cornersOf(mesh, SurfaceMesh::triangleOf(half))) {}

    Vec3 middle() const { return 0.5 * (from + to); }
    Vec3 skin() const { return (corners[0] + corners[1] + corners[2]) / 3; }
    /// From the skin beyond the edge, along the skin; as long as the edge.
    Vec3 outwards() const { return (to - from).cross(areaNormal(corners).normalized()); }
    /// Whether a point lies on the side of the skin, as seen from the edge.
    bool isBeside(const Vec3& point) const { return (point - middle()).dot(outwards()) <= 0; }

    Vec3 from;
    Vec3 to;
    Corners corners;
};

/// The edge nearest to a point among those on its side; none beyond `reach`.
std::optional<RimEdge> nearestOf(const SurfaceMesh& mesh, const std::vector<RimEdge>& rim,
                                 const Vec3& point, double reach) {
    std::optional<RimEdge> nearest;
    double least = reach;
    for (const RimEdge& edge : rim) {
        const Placed placed(mesh, edge.half);
        const double away = distanceToSegment(point, placed.from, placed.to);
        if (away < least && placed.isBeside(point)) {
            least = away;
            nearest = edge;
        }
    }
    return nearest;
}

Vec3 restMiddle(const SurfaceMesh& mesh, int half) {
    return 0.5 * (mesh.restPosition(mesh.origin(half)) + mesh.restPosition(mesh.target(half)));
}

/// The edge that was at the same place before the cut, on its other side.
std::optional<RimEdge> facing(const SurfaceMesh& mesh, const std::vector<RimEdge>& rim,
                              const RimEdge& edge) {
    std::optional<RimEdge> found;
    double least = kFar;
    for (const RimEdge& other : rim) {
        const double away =
            (restMiddle(mesh, other.half) - restMiddle(mesh, edge.half)).squaredNorm();
        if (other.label == (edge.label ^ 1) && away < least) {
            least = away;
            found = other;
        }
    }
    return found;
}

/// The sum of what points out of the skin at the rim within `reach` of a point.
Vec3 outwardsAbout(const SurfaceMesh& mesh, const std::vector<RimEdge>& rim, const RimEdge& at,
                   double reach) {
    const Placed middle(mesh, at.half);
    Vec3 sum = middle.outwards();
    for (const RimEdge& edge : rim) {
        const Placed placed(mesh, edge.half);
        if (edge.label == at.label && (placed.middle() - middle.middle()).norm() < reach) {
            sum += placed.outwards();
        }
    }
    return sum;
}

double lengthOf(const SurfaceMesh& mesh, const std::vector<RimEdge>& rim, int label) {
    Bounds around;
    for (const RimEdge& edge : rim) {
        if (edge.label == label) {
            around.add(mesh.restPosition(mesh.origin(edge.half)));
            around.add(mesh.restPosition(mesh.target(edge.half)));
        }
    }
    return around.diagonal();
}

double meanEdge(const Corners& corners) {
    return ((corners[1] - corners[0]).norm() + (corners[2] - corners[1]).norm() +
            (corners[0] - corners[2]).norm()) /
           3;
}

}  // namespace

std::optional<Incision> incisionNear(const SurfaceMesh& mesh, const Vec3& point, double reach) {
    const std::vector<RimEdge> rim = rimOf(mesh);
    const std::optional<RimEdge> near = nearestOf(mesh, rim, point, reach);
    const std::optional<RimEdge> far = near ? facing(mesh, rim, *near) : std::nullopt;
    if (!far) {
        return std::nullopt;
    }
    const Placed own(mesh, near->half);
    const Placed other(mesh, far->half);
    Incision found{.lips = {own.skin(), other.skin()}};
    found.edgeLength = meanEdge(own.corners);
    found.length = lengthOf(mesh, rim, near->label);
    const double about = hookRadius(found);
    found.across = (outwardsAbout(mesh, rim, *near, about) - outwardsAbout(mesh, rim, *far, about))
                       .normalized();
    found.away = distanceToSegment(point, own.from, own.to);
    found.gap = std::max(0.0, (other.middle() - own.middle()).dot(found.across));
    return found;
}

double hookRadius(const Incision& incision) {
    return std::max(kHook * incision.length, kFewTriangles * incision.edgeLength);
}

double handRadius(const SurfaceMesh& mesh, const Vec3& point, double wanted, const Bounds& piece) {
    const double most = std::min(wanted, kPiece * piece.diagonal());
    const std::optional<Incision> lip = incisionNear(mesh, point, most);
    return lip ? std::min(most, std::max(kLip * lip->length, kFewTriangles * lip->edgeLength))
               : most;
}

}  // namespace kerf::app
