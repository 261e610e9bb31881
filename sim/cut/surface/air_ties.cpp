#include "sim/cut/surface/air_ties.h"

#include <Eigen/Geometry>

#include "sim/cut/surface/broad_phase.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Shares of h: skin nearer than the first carries a node fully, beyond the second not at all.
constexpr double kFullReach = 1.0;
constexpr double kReach = 2.5;
constexpr double kSpacing = 0.3;  // of nodes on an edge in the air
// The sphere about a triangle is taken so much larger that rounding does not matter.
constexpr double kSphereRoom = 1 + 1e-6;

struct SkinPoint {
    int triangle;
    Vec3 weights;
    Vec3 position;
    double distance;
};

Vec3 pointOn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& weights) {
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

OrientedBox boxAround(const Vec3& p, const Vec3& q, double reach) {
    const bool isPoint = p == q;
    const Eigen::Matrix3d axes =
        isPoint ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : sweptAxes({p, q}, {});
    OrientedBox box = orientedBoxAlong(axes, std::array{p, q});
    box.widen(reach);
    return box;
}

/// The skin nearest to points at equal distances on an edge of the rung, where it is within reach.
class NearestSkin {
  public:
    NearestSkin(const SurfaceMesh& mesh, SkinShape shape, const Vec3& p, const Vec3& q, int parts,
                double reach)
        : mesh_(mesh),
          atRest_(shape == SkinShape::rest),
          from_(p),
          way_(q - p),
          parts_(parts),
          reach_(reach),
          length_(way_.norm()),
          nearest_(parts + 1, SkinPoint{-1, Vec3::Zero(), Vec3::Zero(), reach}),
          farthest_(parts + 1, 1e300) {
        points_.reserve(nearest_.size());
        for (int k = 0; k <= parts; ++k) {
            points_.emplace_back(from_ + way_ * share(k));
        }
    }

    const Vec3& point(int k) const { return points_[k]; }
    double share(int k) const { return k / static_cast<double>(parts_); }
    /// Null where there is none.
    const SkinPoint* nearest(int k) const {
        return nearest_[k].triangle < 0 ? nullptr : &nearest_[k];
    }

    /// Each triangle once, all before the first is looked at.
    void add(int triangle) {
        const Triangle& c = mesh_.triangle(triangle);
        const Vec3 center = (at(c[0]) + at(c[1]) + at(c[2])) / 3;
        double radius = 0;
        for (const int v : c) {
            radius = std::max(radius, (at(v) - center).squaredNorm());
        }
        radius = kSphereRoom * std::sqrt(radius);
        const auto [first, last] = partsWithin(center, reach_ + radius);
        for (int k = first; k <= last; ++k) {
            farthest_[k] = std::min(farthest_[k], (point(k) - center).squaredNorm());
        }
        if (first <= last) {
            candidates_.push_back({triangle, center, radius, first, last});
        }
    }

    void lookAtAll() {
        for (double& farthest : farthest_) {
            farthest = kSphereRoom * std::sqrt(farthest);
        }
        for (const Candidate& candidate : candidates_) {
            look(candidate);
        }
    }

  private:
    /// A triangle with a sphere about it, and which points may lie so near.
    struct Candidate {
        int triangle;
        Vec3 center;
        double radius;
        int first, last;
    };

    const Vec3& at(int v) const { return atRest_ ? mesh_.restPosition(v) : mesh_.position(v); }

    // Skips what some centre of a triangle is nearer than, which is most.
    void look(const Candidate& candidate) {
        for (int k = candidate.first; k <= candidate.last; ++k) {
            const Vec3& p = points_[k];
            const double most = std::min(nearest_[k].distance, farthest_[k]) + candidate.radius;
            if ((p - candidate.center).squaredNorm() <= most * most) {
                lookFrom(p, candidate.triangle, nearest_[k]);
            }
        }
    }

    /// Of the points on the edge: the first and the last that may lie so near to `center`. Empty
    /// where they are in the wrong order.
    std::pair<int, int> partsWithin(const Vec3& center, double distance) const {
        if (length_ == 0) {
            return {0, parts_};
        }
        const double along = (center - from_).dot(way_) / length_;
        const double beside = (center - from_).squaredNorm() - along * along;
        if (beside > distance * distance) {
            return {1, 0};
        }
        const double half = std::sqrt(distance * distance - std::max(0.0, beside));
        const auto part = [&](double at) {
            return static_cast<int>(std::clamp(at / length_, -1.0, 2.0) * parts_);
        };
        return {std::max(0, part(along - half) - 1), std::min(parts_, part(along + half) + 1)};
    }

    void lookFrom(const Vec3& p, int triangle, SkinPoint& best) const {
        const Triangle& c = mesh_.triangle(triangle);
        const Vec3 weights = closestWeights(p, at(c[0]), at(c[1]), at(c[2]));
        const Vec3 nearest = pointOn(at(c[0]), at(c[1]), at(c[2]), weights);
        const double distance = (nearest - p).norm();
        if (distance < best.distance || (distance == best.distance && best.triangle < 0)) {
            best = {triangle, weights, nearest, distance};
        }
    }

    const SurfaceMesh& mesh_;
    bool atRest_;
    Vec3 from_;
    Vec3 way_;
    int parts_;
    double reach_;
    double length_;
    std::vector<Vec3> points_;
    std::vector<SkinPoint> nearest_;
    std::vector<double> farthest_;  ///< of each point: the skin is not farther away
    std::vector<Candidate> candidates_;
};

double shareAt(double distance, double h) {
    return std::clamp((kReach - distance / h) / (kReach - kFullReach), 0.0, 1.0);
}

}  // namespace

AirTies::AirTies(const SurfaceMesh& mesh, TriangleFinder& finder,
                 const std::function<bool(int)>& isSkin, double h,
                 const std::vector<RungNode>& rung, SkinShape shape) {
    for (int i = 0; i + 1 < sizeOf(rung); ++i) {
        const RungNode& node = rung[i];
        const RungNode& next = rung[i + 1];
        if (node.attached || (node.vertex >= 0 && next.vertex >= 0)) {
            continue;
        }
        const double length = (next.position - node.position).norm();
        const int parts = std::max(1, static_cast<int>(std::ceil(length / (kSpacing * h))));
        NearestSkin skin(mesh, shape, node.position, next.position, parts, kReach * h);
        for (const int t : finder.near(boxAround(node.position, next.position, kReach * h))) {
            if (isSkin(t)) {
                skin.add(t);
            }
        }
        skin.lookAtAll();
        for (int k = 0; k <= parts; ++k) {
            if (const SkinPoint* near = skin.nearest(k)) {
                ties_.push_back({i, skin.share(k), mesh.triangle(near->triangle), near->weights,
                                 skin.point(k), near->position, shareAt(near->distance, h)});
            }
        }
    }
}

CarriedPoint AirTies::carried(const SurfaceMesh& mesh, const Tie& tie) {
    const Vec3& a = mesh.position(tie.corners[0]);
    const Vec3& b = mesh.position(tie.corners[1]);
    const Vec3& c = mesh.position(tie.corners[2]);
    const Vec3 moved = pointOn(a, b, c, tie.weights) - tie.onSkin;
    return {tie.point + tie.share * moved, unitNormal(a, b, c)};
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

AirTies AirTies::part(int first, int last, int at) const {
    AirTies result;
    for (const Tie& tie : ties_) {
        if (tie.edge >= first && tie.edge < last) {
            result.ties_.push_back(tie);
            result.ties_.back().edge += at - first;
        }
    }
    return result;
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
