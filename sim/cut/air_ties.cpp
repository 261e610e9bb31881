#include "sim/cut/air_ties.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/cut/broad_phase.h"
#include "sim/cut/step.h"
#include "sim/mesh/closest_point.h"

namespace kerf::cut {

namespace {

// Shares of h: skin nearer than the first carries a node fully, beyond the second not at all.
constexpr double kFullReach = 1.0;
constexpr double kReach = 2.5;
constexpr double kSpacing = 0.3;  // of nodes on an edge in the air

struct SkinPoint {
    int triangle;
    Vec3 weights;
    Vec3 position;
    double distance;
};

Vec3 pointOn(const SurfaceMesh& mesh, const Triangle& c, const Vec3& weights) {
    return weights[0] * mesh.position(c[0]) + weights[1] * mesh.position(c[1]) +
           weights[2] * mesh.position(c[2]);
}

Bounds boxOf(const SurfaceMesh& mesh, int t) {
    Bounds box;
    for (const int v : mesh.triangle(t)) {
        box.add(mesh.position(v));
    }
    return box;
}

bool segmentMeets(const Bounds& box, const Vec3& p, const Vec3& q) {
    double from = 0;
    double to = 1;
    for (int k = 0; k < 3; ++k) {
        const double way = q[k] - p[k];
        if (std::fabs(way) < 1e-300) {
            if (p[k] < box.low[k] || p[k] > box.high[k]) {
                return false;
            }
            continue;
        }
        const double a = (box.low[k] - p[k]) / way;
        const double b = (box.high[k] - p[k]) / way;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

OrientedBox boxAround(const Vec3& p, const Vec3& q, double reach) {
    const bool isPoint = p == q;
    const Eigen::Matrix3d axes =
        isPoint ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : sweepAxes({p, q}, {});
    OrientedBox box = orientedBoxAlong(axes, std::array{p, q});
    box.widen(reach);
    return box;
}

/// The skin within reach of an edge of the rung.
class NearbySkin {
  public:
    NearbySkin(const SurfaceMesh& mesh, TriangleFinder& finder,
               const std::function<bool(int)>& isSkin, const Vec3& p, const Vec3& q, double reach)
        : mesh_(mesh), reach_(reach) {
        const auto widened = [reach](Bounds box) {
            box.widen(reach);
            return box;
        };
        for (const int t : finder.near(boxAround(p, q, reach))) {
            const Bounds box = widened(boxOf(mesh, t));
            if (isSkin(t) && segmentMeets(box, p, q)) {
                entries_.push_back({t, box});
            }
        }
    }

    std::optional<SkinPoint> nearest(const Vec3& p) const {
        std::optional<SkinPoint> best;
        for (const Entry& entry : entries_) {
            if ((p.array() < entry.box.low.array()).any() ||
                (p.array() > entry.box.high.array()).any()) {
                continue;
            }
            const Triangle& c = mesh_.triangle(entry.triangle);
            const Vec3 weights =
                closestWeights(p, mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2]));
            const Vec3 at = pointOn(mesh_, c, weights);
            const double distance = (at - p).norm();
            if (distance <= reach_ && (!best || distance < best->distance)) {
                best = SkinPoint{entry.triangle, weights, at, distance};
            }
        }
        return best;
    }

  private:
    struct Entry {
        int triangle;
        Bounds box;  ///< widened by the reach
    };

    const SurfaceMesh& mesh_;
    double reach_;
    std::vector<Entry> entries_;
};

double shareAt(double distance, double h) {
    return std::clamp((kReach - distance / h) / (kReach - kFullReach), 0.0, 1.0);
}

}  // namespace

AirTies::AirTies(const SurfaceMesh& mesh, TriangleFinder& finder,
                 const std::function<bool(int)>& isSkin, double h,
                 const std::vector<RungNode>& rung) {
    for (int i = 0; i + 1 < sizeOf(rung); ++i) {
        const RungNode& node = rung[i];
        const RungNode& next = rung[i + 1];
        if (node.attached || (node.vertex >= 0 && next.vertex >= 0)) {
            continue;
        }
        const NearbySkin skin(mesh, finder, isSkin, node.position, next.position, kReach * h);
        const Vec3 way = next.position - node.position;
        const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / (kSpacing * h))));
        for (int k = 0; k <= parts; ++k) {
            const double part = k / static_cast<double>(parts);
            const Vec3 point = node.position + way * part;
            if (const std::optional<SkinPoint> near = skin.nearest(point)) {
                ties_.push_back({i, part, mesh.triangle(near->triangle), near->weights, point,
                                 near->position, shareAt(near->distance, h)});
            }
        }
    }
}

CarriedPoint AirTies::carried(const SurfaceMesh& mesh, const Tie& tie) {
    const Vec3 moved = pointOn(mesh, tie.corners, tie.weights) - tie.onSkin;
    const Vec3& a = mesh.position(tie.corners[0]);
    const Vec3 normal =
        (mesh.position(tie.corners[1]) - a).cross(mesh.position(tie.corners[2]) - a);
    return {tie.point + tie.share * moved, normal.stableNormalized()};
}

void AirTies::follow(const SurfaceMesh& mesh, std::vector<RungNode>& rung) const {
    for (const Tie& tie : ties_) {
        const bool isNode = tie.part == 0 || tie.part == 1;
        if (isNode && rung[tie.edge + static_cast<int>(tie.part)].vertex < 0) {
            rung[tie.edge + static_cast<int>(tie.part)].position = carried(mesh, tie).position;
        }
    }
}

void AirTies::addVertices(std::vector<int>& vertices) const {
    for (const Tie& tie : ties_) {
        vertices.insert(vertices.end(), tie.corners.begin(), tie.corners.end());
    }
}

std::vector<CarriedPoint> AirTies::between(const SurfaceMesh& mesh, int index) const {
    std::vector<CarriedPoint> points;
    for (const Tie& tie : ties_) {
        if (tie.edge == index && tie.part > 0 && tie.part < 1) {
            points.push_back(carried(mesh, tie));
        }
    }
    return points;
}

}  // namespace kerf::cut
