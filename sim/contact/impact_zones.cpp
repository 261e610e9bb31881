#include "sim/contact/impact_zones.h"

#include <Eigen/Geometry>

#include "sim/base/math.h"
#include "sim/base/predicates.h"
#include "sim/body/piece_masses.h"
#include "sim/body/rest_geometry.h"
#include "sim/contact/contact_solver.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"
#include "sim/repair/surface_contact.h"

namespace kerf {

namespace {

constexpr double kRounding = 0x1p-20;   // of the largest coordinate: a depth that is none
constexpr double kLeastVolume = 1e-6;   // of a piece at rest: a lack that is none
constexpr double kPinnedWeight = 1000;  // of what is pinned, in the motion of a zone
constexpr double kNoFloor = std::numeric_limits<double>::lowest();

struct BoxedTriangle {
    int slot = 0;
    Triangle corners{};
    Bounds box{};
};

/// Whether corners of `a` lie on both sides of the plane of `b`, as far as doubles tell.
bool straddles(const Corners& a, const Corners& b) {
    const auto liesOn = [&](int side) {
        return std::ranges::any_of(
            a, [&](const Vec3& p) { return estimate3d(b[0], b[1], b[2], p).sign() == side; });
    };
    return liesOn(1) && liesOn(-1);
}

/// A step of a body, and what zones make of it.
class Impact {
  public:
    Impact(const MovedBody& body, SurfaceMesh& mesh)
        : body_(body),
          mesh_(mesh),
          floor_(body.floor.value_or(kNoFloor)),
          hair_(shared::kHair * contactEdgeLength(body.model)),
          masses_(unitMasses(body.model)),
          zones_(masses_.size()),
          moved_(masses_.size(), true),
          inZone_(masses_.size(), false) {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const Vec3& place = mesh.position(v);
            rounding_ = std::max(rounding_, kRounding * place.cwiseAbs().maxCoeff());
            ways_.push_back(place - body.before[v]);
            velocities_.push_back(mesh.velocity(v));
            if (place.y() < floor_ + rounding_) {
                velocities_[v].y() = std::min(velocities_[v].y(), 0.0);  // it was lifted out
            }
            masses_[v] *= isPinned(v) ? kPinnedWeight : 1;
        }
        for (const int t : body.model.meshTriangle) {
            triangles_.push_back({t, mesh.triangle(t)});
        }
    }

    /// From left to right, among what has moved since the last look. Returns whether a zone grew.
    bool joinCrossings() {
        for (BoxedTriangle& t : triangles_) {
            t.box = boxOf(cornersOf(mesh_, t.slot));
        }
        std::ranges::sort(triangles_, {},
                          [](const BoxedTriangle& t) { return std::pair(t.box.low.x(), t.slot); });
        bool grew = false;
        for (auto a = triangles_.begin(); a != triangles_.end(); ++a) {
            const bool moved = hasMoved(*a);
            for (auto b = a + 1; b != triangles_.end() && b->box.low.x() <= a->box.high.x(); ++b) {
                if (a->box.overlaps(b->box) && (moved || hasMoved(*b)) && crossAnew(*a, *b)) {
                    grew = join(*a, *b) || grew;
                }
            }
        }
        return grew;
    }

    void moveZones() {
        if (volumes_.empty()) {
            volumes_ = pieceVolumes();  // nothing was moved yet
        }
        std::map<int, std::vector<int>> zones;
        for (int v = 0; v < mesh_.vertexCount(); ++v) {
            moved_[v] = false;
            zones[zones_.root(v)].push_back(v);
        }
        for (const auto& [root, vertices] : zones) {
            if (vertices.size() > 1) {
                move(vertices);
            }
        }
    }

    /// Gives pieces back the volume that the step left them, by what is in no zone: along the
    /// normal, the lighter the farther.
    void keepVolumes() {
        const std::vector<double> lacking = lackingVolumes();
        std::vector<Vec3> gradients(masses_.size(), Vec3::Zero());
        for (const BoxedTriangle& t : triangles_) {
            for (const int v : t.corners) {
                gradients[v] += areaNormal(cornersOf(mesh_, t.slot)) / 6;
            }
        }
        std::vector<double> sums(lacking.size(), 0);
        for (int v = 0; v < mesh_.vertexCount(); ++v) {
            if (isFree(v)) {
                sums[body_.model.pieceOfVertex[v]] += gradients[v].squaredNorm() / masses_[v];
            }
        }
        for (int v = 0; v < mesh_.vertexCount(); ++v) {
            const int piece = body_.model.pieceOfVertex[v];
            if (isFree(v) && lacking[piece] != 0 && sums[piece] > 0) {
                Vec3 place =
                    mesh_.position(v) + lacking[piece] / (sums[piece] * masses_[v]) * gradients[v];
                place.y() = std::max(place.y(), floor_);
                mesh_.setState(v, nearestFloats(place), mesh_.velocity(v));
                moved_[v] = true;
            }
        }
    }

  private:
    std::vector<double> pieceVolumes() const {
        std::vector<double> volumes(body_.model.pieces.size(), 0);
        for (const auto& t : body_.model.triangles) {
            const Vec3& a = mesh_.position(static_cast<int>(t[0]));
            const Vec3& b = mesh_.position(static_cast<int>(t[1]));
            volumes[t[3] >> 8] += a.dot(b.cross(mesh_.position(static_cast<int>(t[2])))) / 6;
        }
        return volumes;
    }

    /// 0 where no volume is held, or nothing lacks but by rounding.
    std::vector<double> lackingVolumes() const {
        std::vector<double> lacking = pieceVolumes();
        for (std::size_t p = 0; p < lacking.size(); ++p) {
            const PieceModel& piece = body_.model.pieces[p];
            lacking[p] = volumes_[p] - lacking[p];
            if (!piece.holdsVolume || std::fabs(lacking[p]) < kLeastVolume * piece.restVolume) {
                lacking[p] = 0;
            }
        }
        return lacking;
    }

    /// In a piece, not pinned and in no zone.
    bool isFree(int v) const {
        return body_.model.pieceOfVertex[v] >= 0 && !isPinned(v) && !inZone_[v];
    }

    bool hasMoved(const BoxedTriangle& t) const {
        return std::ranges::any_of(t.corners, [&](int v) { return moved_[v]; });
    }

    bool crossAnew(const BoxedTriangle& a, const BoxedTriangle& b) const {
        const std::vector<int>& pieces = body_.model.pieceOfVertex;
        if (!body_.apart && pieces[a.corners[0]] != pieces[b.corners[0]]) {
            return false;
        }
        const Corners ofA = cornersOf(mesh_, a.slot);
        const Corners ofB = cornersOf(mesh_, b.slot);
        if (!straddles(ofA, ofB) || !straddles(ofB, ofA) || !repair::passThrough(ofA, ofB)) {
            return false;
        }
        const bool acrossSlit = areAcrossSlit(a, b);
        return (!acrossSlit || repair::crossingDepth(ofA, ofB) > hair_) &&
               !crossedBefore(a.corners, b.corners, acrossSlit ? hair_ : rounding_);
    }

    /// Two walls, or triangles with copies of one point.
    bool areAcrossSlit(const BoxedTriangle& a, const BoxedTriangle& b) const {
        const auto isCopyIn = [&](int v) {
            return std::ranges::any_of(b.corners, [&](int w) {
                return w != v && mesh_.copyGroup(v) >= 0 &&
                       mesh_.copyGroup(v) == mesh_.copyGroup(w);
            });
        };
        const auto isWall = [&](int slot) { return mesh_.kind(slot) == SurfaceKind::wall; };
        return (isWall(a.slot) && isWall(b.slot)) || std::ranges::any_of(a.corners, isCopyIn);
    }

    bool crossedBefore(const Triangle& a, const Triangle& b, double least) const {
        const auto& x = body_.before;
        const Corners ofA{x[a[0]], x[a[1]], x[a[2]]};
        const Corners ofB{x[b[0]], x[b[1]], x[b[2]]};
        return repair::passThrough(ofA, ofB) && repair::crossingDepth(ofA, ofB) > least;
    }

    bool join(const BoxedTriangle& a, const BoxedTriangle& b) {
        bool grew = false;
        for (const int v : {a.corners[1], a.corners[2], b.corners[0], b.corners[1], b.corners[2]}) {
            grew = grew || zones_.root(v) != zones_.root(a.corners[0]);
            zones_.join(v, a.corners[0]);
        }
        return grew;
    }

    /// As one rigid body with the momenta of all, from where they were. What would get below the
    /// floor does not turn: about its middle, it would climb.
    void move(const std::vector<int>& vertices) {
        std::vector<FittedVertex> members;
        Vec3 middle = Vec3::Zero();
        double mass = 0;
        for (const int v : vertices) {
            members.push_back({.weight = masses_[v], .at = body_.before[v], .velocity = ways_[v]});
            middle += masses_[v] * body_.before[v];
            mass += masses_[v];
        }
        middle /= mass;
        RigidMotion way = rigidMotionOf(members, middle);
        for (std::size_t i = 0; i < members.size(); ++i) {
            members[i].velocity = velocities_[vertices[i]];
        }
        RigidMotion speed = rigidMotionOf(members, middle);
        Eigen::AngleAxisd turn(way.spin.norm(), way.spin.normalized());
        const auto placeOf = [&](const FittedVertex& m) {
            return Vec3(middle + way.velocity + turn * (m.at - middle));
        };
        const auto height = [&](const FittedVertex& m) { return placeOf(m).y() - floor_; };
        if (height(*std::ranges::min_element(members, {}, height)) < 0) {
            turn.angle() = 0;
            way.velocity.y() -=
                std::min(height(*std::ranges::min_element(members, {}, height)), 0.0);
            speed.spin.setZero();
            speed.velocity.y() = std::max(speed.velocity.y(), 0.0);
        }
        for (std::size_t i = 0; i < members.size(); ++i) {
            const int v = vertices[i];
            inZone_[v] = true;
            if (!isPinned(v)) {
                Vec3 place = nearestFloats(placeOf(members[i]));
                place.y() = height(members[i]) < rounding_ ? nearestFloat(floor_) : place.y();
                const Vec3 arm = members[i].at - middle;
                mesh_.setState(v, place, nearestFloats(speed.velocity + speed.spin.cross(arm)));
                moved_[v] = true;
            }
        }
    }

    bool isPinned(int v) const {
        return std::ranges::binary_search(body_.pinned, static_cast<std::uint32_t>(v));
    }

    const MovedBody& body_;
    SurfaceMesh& mesh_;
    const double floor_;  ///< [m]
    const double hair_;   ///< up to here walls of a slit may lie in each other [m]
    std::vector<double> masses_;
    std::vector<Vec3> ways_, velocities_;  ///< of the step as it was solved [m], [m/s]
    std::vector<BoxedTriangle> triangles_;
    UnionFind zones_;
    std::vector<double> volumes_;  ///< of pieces, as the step left them [m^3]
    std::vector<char> moved_, inZone_;
    double rounding_ = 0;  ///< [m]
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.empty() ? 0 : *middle;
}

}  // namespace

ThinWalls thinWalls(const BodyModel& model) {
    std::vector<float> longest(model.restPositions.size(), 0);
    for (const EdgeConstraint& edge : model.edges) {
        for (const std::uint32_t v : verticesOf(edge)) {
            longest[v] = std::max(longest[v], edge.rest_length);
        }
    }
    std::vector<double> walls;
    std::vector<double> edges;
    for (const IspcConstraint& column : model.ispcs) {
        if (column.rest_length < longest[column.vertex]) {
            walls.push_back(column.rest_length);
            edges.push_back(longest[column.vertex]);
        }
    }
    const double all = std::max(static_cast<double>(model.ispcs.size()), 1.0);
    return {static_cast<double>(walls.size()) / all, medianOf(walls), medianOf(edges)};
}

bool stopCrossings(const MovedBody& body, SurfaceMesh& mesh) {
    Impact impact(body, mesh);
    bool any = false;
    while (impact.joinCrossings()) {
        impact.moveZones();
        impact.keepVolumes();
        any = true;
    }
    return any;
}

}  // namespace kerf
