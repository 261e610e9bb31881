#include "sim/cut/plan/input/slit_opening.h"

#include "sim/cut/plan/input/step.h"
#include "sim/mesh/triangle.h"

namespace kerf::cut {

namespace {

// Shares of h: walls nearer to the strip are retraced, but none that lie beside the front, which is
// inside the body there.
constexpr double kRetraced = 0.1;
// A blade that comes round to its own past meets it less exactly: by hand, and in other steps.
constexpr double kRetracedPast = 0.25;
constexpr double kBesideFront = 0.25;
constexpr double kAtFrontEnd = 1e-3;
constexpr double kFarthest = 0.5;
const double kAlong = std::cos(5 * M_PI / 180);
// As far as chords of two turns differ on a bend that is two edges narrow.
const double kAlongPast = std::cos(40 * M_PI / 180);

struct SweptTriangle {
    std::array<Vec3, 3> at;
    Vec3 normal;  ///< twice its area long
};

/// The strip of the step, without the blade's offset and with the nodes of the rung alone.
std::vector<SweptTriangle> sweptTriangles(const OpeningInput& step) {
    std::vector<SweptTriangle> triangles;
    triangles.reserve(2 * step.rung.size());
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = areaNormal(a, b, c);
        if (normal.norm() > 1e-6 * step.h * step.h) {
            triangles.push_back({{a, b, c}, normal});
        }
    };
    const auto onBlade = [&](const RungNode& node) {
        return pointOn(step.blade, std::clamp(node.s, 0.0, 1.0));
    };
    for (std::size_t i = 0; i + 1 < step.rung.size(); ++i) {
        const Vec3& p = step.rung[i].position;
        const Vec3& q = step.rung[i + 1].position;
        add(p, q, onBlade(step.rung[i + 1]));
        add(p, onBlade(step.rung[i + 1]), onBlade(step.rung[i]));
    }
    return triangles;
}

bool startsChain(const OpeningInput& step, std::size_t i) {
    return step.rung[i].attached && (i == 0 || !step.rung[i - 1].attached);
}

/// Whether p lies beside the inside of a chain of front edges, not beyond its ends.
bool isBesideFront(const OpeningInput& step, const Vec3& p) {
    for (std::size_t i = 0; i + 1 < step.rung.size(); ++i) {
        if (!step.rung[i].attached) {
            continue;
        }
        const Vec3& a = step.rung[i].position;
        const Vec3 along = step.rung[i + 1].position - a;
        const double length = along.norm();
        const double way = length > 0 ? (p - a).dot(along) / length : 0;
        const double end = kAtFrontEnd * step.h;
        const bool beforeChain = way <= end && startsChain(step, i);
        const bool behindChain = way >= length - end && !step.rung[i + 1].attached;
        const double part = length > 0 ? std::clamp(way / length, 0.0, 1.0) : 0;
        const double distance = (p - a - along * part).norm();
        if (!beforeChain && !behindChain && distance < kBesideFront * step.h) {
            return true;
        }
    }
    return false;
}

class SlitOpener {
  public:
    SlitOpener(const SurfaceMesh& mesh, const BroadPhase& broadPhase, const OpeningInput& step)
        : mesh_(mesh), broadPhase_(broadPhase), step_(step), swept_(sweptTriangles(step)) {}

    std::map<int, Vec3> run() {
        if (step_.sides.empty() && !comesNearOldWall()) {
            return {};
        }
        for (const RungNode& node : step_.rung) {
            fixed_.insert(node.vertex);
        }
        std::map<int, Vec3> found;
        for (const int v : oldWallVertices()) {
            found[v] = intoMaterial(v);
        }
        step_.sides.merge(found);
        takeNeighboursAlong();
        if (step_.takesSeamsAlong) {
            takeSeamsAlong();
        }
        std::map<int, Vec3> displacements;
        for (const auto& [v, inwards] : step_.sides) {
            if (!step_.takesSeamsAlong && isEndOfPast(v)) {
                displacements[v] = -offsetOf(v).distance * offsetOf(v).normal;
            } else if (opens(v, inwards) && fixed_.count(v) == 0) {
                const PlaneOffset offset = offsetOf(v);
                const int side = inwards.dot(offset.normal) > 0 ? 1 : -1;
                const double way = step_.opening * step_.h - side * offset.distance;
                if (way > 0 && way < kFarthest * step_.h) {
                    displacements[v] = side * way * offset.normal;
                }
            }
        }
        return displacements;
    }

  private:
    /// Where a vertex lies to the nearest part of the strip.
    struct PlaneOffset {
        double distance;  ///< to its plane, signed [m]
        Vec3 normal;
    };

    // A stroke that comes back to where it has cut is often not done there.
    bool isOldWall(int t) const {
        return mesh_.kind(t) == SurfaceKind::wall &&
               (mesh_.wallLabel(t) / 2 != step_.stroke || isPast(t));
    }

    bool isPast(int t) const {
        return mesh_.wallLabel(t) / 2 == step_.stroke &&
               std::ranges::any_of(mesh_.triangle(t),
                                   [&](int v) { return step_.past.contains(v); });
    }

    bool isOlderThanTransit(int v) const {
        return v < step_.firstVertexOfTransit || step_.past.contains(v) ||
               step_.onSeams.count(v) > 0;
    }

    double retracedAt(int v) const {
        return (step_.past.contains(v) ? kRetracedPast : kRetraced) * step_.h;
    }

    /// Whether v lies where the stroke's walls began, and the blade comes upon it. It is seen on
    /// the strip then, which so runs into the gap however little it misses it.
    bool isEndOfPast(int v) {
        return step_.past.contains(v) && fixed_.count(v) == 0 && isNear(v) &&
               !isBesideFront(step_, mesh_.position(v)) && isEndOfSlit(mesh_, v, step_.stroke);
    }

    bool mayMove(int v) const { return isOlderThanTransit(v) && fixed_.count(v) == 0; }

    bool comesNearOldWall() const {
        std::vector<Vec3> points;
        points.reserve(3 * swept_.size());
        for (const SweptTriangle& s : swept_) {
            points.insert(points.end(), s.at.begin(), s.at.end());
        }
        broadPhase_.takeAround(points, (hasPast() ? kRetracedPast : kRetraced) * step_.h);
        return std::ranges::any_of(broadPhase_.entries(), [this](const BroadPhase::Entry& entry) {
            return isOldWall(entry.triangle);
        });
    }

    bool hasPast() const { return step_.past.first < step_.past.end; }

    // Of walls that the strip comes near.
    std::set<int> oldWallVertices() {
        std::set<int> vertices;
        for (const SweptTriangle& s : swept_) {
            const auto take = [&](double reach, bool past) {
                for (const int t : broadPhase_.query(s.at[0], s.at[1], s.at[2], reach * step_.h)) {
                    if (isOldWall(t) && isPast(t) == past && isRetraced(t)) {
                        const Triangle& c = mesh_.triangle(t);
                        vertices.insert(c.begin(), c.end());
                    }
                }
            };
            take(kRetraced, false);
            if (hasPast()) {
                take(kRetracedPast, true);
            }
        }
        return vertices;
    }

    /// Walls that are past may lie where nobody has looked in this step.
    void bringAround(int v) const {
        if (mesh_.isOld(v)) {
            std::vector<int> ring{v};
            mesh_.forEachOutgoing(
                v, [&](int h) { ring.push_back(mesh_.triangle(h / 3)[(h % 3 + 1) % 3]); });
            mesh_.bring(ring);
        }
    }

    const PlaneOffset& offsetOf(int v) {
        const auto known = offsets_.find(v);
        if (known != offsets_.end()) {
            return known->second;
        }
        if (mesh_.outgoing(v) < 0) {
            return offsets_.emplace(v, PlaneOffset{1e300, Vec3::Zero()}).first->second;  // gone
        }
        bringAround(v);
        const Vec3& p = mesh_.position(v);
        PlaneOffset offset{1e300, Vec3::Zero()};
        double least = 1e300;
        for (const SweptTriangle& s : swept_) {
            const Vec3 w = closestWeights(p, s.at[0], s.at[1], s.at[2]);
            const double distance = (w[0] * s.at[0] + w[1] * s.at[1] + w[2] * s.at[2] - p).norm();
            if (distance < least) {
                least = distance;
                const Vec3 normal = s.normal.normalized();
                offset = {normal.dot(p - s.at[0]), normal};
            }
        }
        return offsets_[v] = offset;
    }

    bool isNear(int v) { return std::fabs(offsetOf(v).distance) <= retracedAt(v); }

    bool isRetraced(int t) {
        const Triangle& c = mesh_.triangle(t);
        return std::all_of(c.begin(), c.end(), [&](int v) { return isNear(v); });
    }

    bool opens(int v, const Vec3& inwards) const {
        return inwards.squaredNorm() > 0 && mesh_.outgoing(v) >= 0;
    }

    // The normal of the strip that points into the material behind the retraced walls; zero where
    // there is no telling: at the end of a slit.
    Vec3 intoMaterial(int v) {
        const Vec3& p = mesh_.position(v);
        if (!mayMove(v) || isBesideFront(step_, p)) {
            return Vec3::Zero();
        }
        Vec3 sum = Vec3::Zero();
        double area = 0;
        mesh_.forEachOutgoing(v, [&](int h) {
            if (isOldWall(h / 3) && isRetraced(h / 3)) {
                const Vec3 normal =
                    areaNormal(p, mesh_.position(mesh_.target(h)), mesh_.position(mesh_.apex(h)));
                sum += normal;
                area += normal.norm();
            }
        });
        const double across = sum.dot(offsetOf(v).normal);
        const double along = step_.past.contains(v) ? kAlongPast : kAlong;
        if (area == 0 || std::fabs(across) < along * area) {
            return Vec3::Zero();
        }
        return across < 0 ? offsetOf(v).normal : Vec3(-offsetOf(v).normal);
    }

    // Skin that lies so near goes with the rim of the slit beside it.
    void takeNeighboursAlong() {
        std::map<int, std::vector<Vec3>> ofNeighbour;
        for (const auto& [v, inwards] : step_.sides) {
            if (opens(v, inwards) && !step_.past.contains(v)) {
                mesh_.forEachOutgoing(
                    v, [&, way = inwards](int h) { ofNeighbour[mesh_.target(h)].push_back(way); });
            }
        }
        for (const auto& [v, ways] : ofNeighbour) {
            const bool oneWay =
                std::all_of(ways.begin(), ways.end(),
                            [&, &all = ways](const Vec3& w) { return w.dot(all.front()) > 0; });
            if (oneWay && mayMove(v) && !touchesOldWall(v) && isNear(v)) {
                step_.sides.emplace(v, ways.front());
            }
        }
    }

    // Where the strip leaves the slit at an angle, the walls around a new vertex no longer tell to
    // which side they open. Seen closed, it lies exactly on the front that it faces.
    void takeSeamsAlong() {
        for (const int v : step_.onSeams) {
            Vec3& way = step_.sides.try_emplace(v, Vec3::Zero()).first->second;
            if (mesh_.outgoing(v) >= 0 && !opens(v, way) && mayMove(v) &&
                !isBesideFront(step_, mesh_.position(v))) {
                way = wayOfNeighbours(v);
            }
        }
    }

    /// In which all neighbours that open do so; zero where they differ or none does.
    Vec3 wayOfNeighbours(int v) const {
        Vec3 way = Vec3::Zero();
        bool oneWay = true;
        mesh_.forEachOutgoing(v, [&](int h) {
            const auto side = step_.sides.find(mesh_.target(h));
            if (side != step_.sides.end() && opens(side->first, side->second)) {
                oneWay = oneWay && (way.isZero(0) || way.dot(side->second) > 0);
                way = side->second;
            }
        });
        return oneWay ? way : Vec3(Vec3::Zero());
    }

    bool touchesOldWall(int v) {
        bool touches = false;
        mesh_.forEachOutgoing(v, [&](int h) { touches |= isOldWall(h / 3) && isRetraced(h / 3); });
        return touches;
    }

    const SurfaceMesh& mesh_;
    const BroadPhase& broadPhase_;
    const OpeningInput& step_;
    std::vector<SweptTriangle> swept_;
    std::set<int> fixed_;
    std::map<int, PlaneOffset> offsets_;
};

}  // namespace

bool isEndOfSlit(const SurfaceMesh& mesh, int v, int stroke) {
    bool isEnd = false;
    if (mesh.outgoing(v) >= 0) {
        mesh.forEachOutgoing(v, [&](int h) {
            const int label = mesh.wallLabel(h / 3);
            isEnd |= label == 2 * stroke && mesh.wallLabel(mesh.twin(h) / 3) == label + 1;
        });
    }
    return isEnd;
}

SlitOpening::SlitOpening(const SurfaceMesh& mesh, const BroadPhase& broadPhase,
                         const OpeningInput& step)
    : displacements_(SlitOpener(mesh, broadPhase, step).run()) {
    for (const auto& [v, way] : displacements_) {
        reach_ = std::max(reach_, way.norm());
        opensPast_ |= step.past.contains(v);
    }
}

Vec3 SlitOpening::displacement(int v) const {
    const auto at = displacements_.find(v);
    return at == displacements_.end() ? Vec3(Vec3::Zero()) : at->second;
}

}  // namespace kerf::cut
