#include "sim/cut/plan/air_edges.h"

#include <Eigen/Geometry>

#include "sim/cut/exact/piercing.h"
#include "sim/cut/plan/input/step.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"

namespace kerf::cut {

namespace {

// Heights above the skin that are tried, shares of h.
constexpr std::array<double, 7> kHeights{0.15, 0.3, 0.5, 0.8, 1.2, 1.8, 2.5};
// Shorter edges cross an older slit and belong to the strip's clusters (share of h).
constexpr double kShortestAirEdge = 0.05;
// How far out (shares of h) carried points are moved in addition.
constexpr std::array<double, 5> kLifts{0, 0.05, 0.1, 0.2, 0.4};

class AirEdges {
  public:
    AirEdges(const SurfaceMesh& mesh, const BroadPhase& broadPhase, const SlitOpening& opening,
             const Blade& blade, double h)
        : mesh_(mesh), broadPhase_(broadPhase), opening_(opening), blade_(blade), h_(h) {}

    /// The nodes to put between two neighbours of the rung; nothing where none are needed or
    /// none help. `carriedPoints` gives the points of the edge that went along with the skin.
    template <class CarriedPoints>
    std::vector<RungNode> detour(const RungNode& from, const RungNode& to,
                                 const CarriedPoints& carriedPoints) const {
        const double length = (to.position - from.position).norm();
        if (length < kShortestAirEdge * h_ || !isPierced(from, to)) {
            return {};
        }
        const std::vector<CarriedPoint> carried = carriedPoints();
        for (const double lift : kLifts) {
            const std::vector<RungNode> path = carriedPath(from, to, carried, lift * h_);
            if (isClear(path)) {
                return inner(straightened(path));
            }
        }
        const bool held = from.vertex >= 0 || to.vertex >= 0;
        return held ? detourAbove(from, to) : std::vector<RungNode>{};
    }

  private:
    std::vector<RungNode> detourAbove(const RungNode& from, const RungNode& to) const {
        for (const double height : kHeights) {
            for (const bool backwards : {false, true}) {
                const std::vector<RungNode> path = pathAbove(from, to, height * h_, backwards);
                if (isOrdered(path) && isClear(path)) {
                    return inner(path);
                }
            }
        }
        return {};
    }

    static std::vector<RungNode> inner(const std::vector<RungNode>& path) {
        return {path.begin() + 1, path.end() - 1};
    }

    // Its s stay between those of its ends and in order, whatever the skin did to it.
    std::vector<RungNode> carriedPath(const RungNode& from, const RungNode& to,
                                      const std::vector<CarriedPoint>& carried, double lift) const {
        std::vector<RungNode> path{from};
        const double share = 1.0 / (static_cast<double>(carried.size()) + 1);
        for (std::size_t i = 0; i < carried.size(); ++i) {
            RungNode node = airNode(carried[i].position + lift * inSweptSurface(carried[i]));
            node.s = from.s + (to.s - from.s) * share * (static_cast<double>(i) + 1);
            path.push_back(node);
        }
        path.push_back(to);
        return path;
    }

    // Outwards, but not out of the surface that the blade has swept.
    Vec3 inSweptSurface(const CarriedPoint& point) const {
        const Vec3 along = (blade_.b - blade_.a).normalized();
        const Vec3 across = along.cross(point.position - blade_.a).stableNormalized();
        return (point.outward - across * across.dot(point.outward)).stableNormalized();
    }

    // Without the nodes that it does not need.
    std::vector<RungNode> straightened(const std::vector<RungNode>& path) const {
        std::vector<RungNode> result{path.front()};
        for (std::size_t i = 0; i + 1 < path.size();) {
            std::size_t next = path.size() - 1;
            while (next > i + 1 && isPierced(path[i], path[next])) {
                --next;
            }
            result.push_back(path[next]);
            i = next;
        }
        return result;
    }

    // Straight up from the skin, or half backwards to where the blade came from.
    std::vector<RungNode> pathAbove(const RungNode& from, const RungNode& to, double height,
                                    bool backwards) const {
        std::vector<RungNode> path{from};
        for (const RungNode& end : {from, to}) {
            if (end.vertex < 0) {
                continue;
            }
            Vec3 up = outwardNormal(end.vertex);
            if (backwards) {
                up = (up + awayFromBlade(end)).normalized();
            }
            path.push_back(airNode(end.position + height * up));
        }
        path.push_back(to);
        return path;
    }

    RungNode airNode(const Vec3& position) const {
        const Vec3 along = blade_.b - blade_.a;
        return {position, (position - blade_.a).dot(along) / along.squaredNorm(), -1, false};
    }

    Vec3 awayFromBlade(const RungNode& node) const {
        return across(blade_, node.position - blade_.a).normalized();
    }

    // The two walls of the slit cancel; what remains is the skin's.
    Vec3 outwardNormal(int v) const {
        Vec3 normal = Vec3::Zero();
        mesh_.forEachOutgoing(v, [&](int h) {
            normal += areaNormal(mesh_.position(v), mesh_.position(mesh_.target(h)),
                                 mesh_.position(mesh_.apex(h)));
        });
        return normal.squaredNorm() > 0 ? Vec3(normal.normalized()) : normal;
    }

    static bool isOrdered(const std::vector<RungNode>& path) {
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            if (path[i].s >= path[i + 1].s) {
                return false;
            }
        }
        return true;
    }

    bool isClear(const std::vector<RungNode>& path) const {
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            if (isPierced(path[i], path[i + 1])) {
                return false;
            }
        }
        return true;
    }

    bool isPierced(const RungNode& from, const RungNode& to) const {
        for (const int t :
             broadPhase_.query(from.position, to.position, to.position, opening_.reach())) {
            if (!touches(t, from.vertex) && !touches(t, to.vertex) &&
                crosses(from.position, to.position, t)) {
                return true;
            }
        }
        return false;
    }

    bool touches(int t, int v) const {
        const Triangle& c = mesh_.triangle(t);
        return v >= 0 && (c[0] == v || c[1] == v || c[2] == v);
    }

    bool crosses(const Vec3& p, const Vec3& q, int t) const {
        const Triangle& ids = mesh_.triangle(t);
        std::array<Vec3, 3> c;
        for (int i = 0; i < 3; ++i) {
            c[i] = mesh_.position(ids[i]) + opening_.displacement(ids[i]);
        }
        return pierces(p, q, c);
    }

    const SurfaceMesh& mesh_;
    const BroadPhase& broadPhase_;
    const SlitOpening& opening_;
    const Blade& blade_;
    double h_;
};

/// What a connected part of the border of the new walls meets.
struct Reach {
    bool start = false;      ///< behind the old front
    bool front = false;      ///< where the new walls end
    std::set<int> oldWalls;  ///< by label
    /// The material beside the start is parted from all that lies ahead.
    bool endsAtOldWall() const { return !front && oldWalls.size() == 1; }
};

bool liesOnOldRung(const OutlineEdge& edge, const std::vector<CutNode>& nodes) {
    return edge.kind == OutlineKind::free && nodes[edge.from].layout.y() == 0 &&
           nodes[edge.to].layout.y() == 0;
}

}  // namespace

void clearAirEdges(const SurfaceMesh& mesh, const BroadPhase& broadPhase,
                   const SlitOpening& opening, const Blade& blade, double h,
                   const std::function<const AirTies&()>& ties, std::vector<RungNode>& rung) {
    const AirEdges edges(mesh, broadPhase, opening, blade, h);
    std::vector<RungNode> cleared;
    for (std::size_t i = 0; i < rung.size(); ++i) {
        cleared.push_back(rung[i]);
        if (i + 1 < rung.size() && !rung[i].attached) {
            const std::vector<RungNode> detour = edges.detour(
                rung[i], rung[i + 1], [&] { return ties().between(mesh, static_cast<int>(i)); });
            cleared.insert(cleared.end(), detour.begin(), detour.end());
        }
    }
    rung = std::move(cleared);
}

std::set<int> piecesOfFront(const std::vector<RungNode>& rung,
                            const std::vector<int>& pieceOfVertex) {
    std::set<int> pieces;
    for (const RungNode& node : rung) {
        if (node.attached) {
            pieces.insert(pieceOfVertex[node.vertex]);
        }
    }
    return pieces;
}

bool leavesBridge(const SurfaceMesh& mesh, int stroke, const std::set<int>& pieces,
                  const StepPlan& plan) {
    const std::vector<CutNode>& nodes = plan.curves.nodes;
    UnionFind parts(nodes.size());
    for (const OutlineEdge& edge : plan.outline.edges) {
        parts.join(edge.from, edge.to);
    }
    std::map<int, Reach> reached;
    for (const FrontPoint& point : plan.outline.front) {
        reached[parts.root(point.node)].front |= point.attached;
    }
    for (const OutlineEdge& edge : plan.outline.edges) {
        if (pieces.contains(edge.piece) && liesOnOldRung(edge, nodes)) {
            reached[parts.root(edge.from)].start = true;
        }
    }
    for (const Segment& segment : plan.curves.segments) {
        const int label = mesh.wallLabel(segment.triangle);
        if (label >= 0 && label / 2 == stroke) {
            reached[parts.root(segment.from)].oldWalls.insert(label);
        }
    }
    std::set<int> sides;
    for (const auto& [root, reach] : reached) {
        if (reach.start && !reach.endsAtOldWall()) {
            return true;
        }
        if (reach.start) {
            sides.insert(*reach.oldWalls.begin());
        }
    }
    return sides.size() > 1;
}

}  // namespace kerf::cut
