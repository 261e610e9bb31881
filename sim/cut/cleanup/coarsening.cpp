#include "sim/cut/cleanup/coarsening.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "sim/cut/cleanup/collapse.h"
#include "sim/cut/cleanup/one_ring.h"
#include "sim/cut/cleanup/self_piercing.h"
#include "sim/cut/plan/input/step.h"

namespace kerf::cut {

namespace {

// Shares of the length aimed at.
constexpr double kShort = 4.0 / 5.0;
constexpr double kLong = 4.0 / 3.0;
// Height over longest edge that a collapse may leave, unless it was worse before.
constexpr double kLeastQuality = 0.3;
constexpr int kMostCoarsenings = 8;

struct ShortEdge {
    double length;
    Edge ends;  ///< the first copies of both
    int halfEdge;
    auto key() const { return std::tuple(length, ends, halfEdge); }
};

bool isInsideWall(const SharedStar& star) {
    return std::ranges::all_of(
        star.edges, [](const SharedEdge& edge) { return edge.type() == SharedEdgeType::wall; });
}

double qualityOf(const Corners& corners) {
    const double longest = longestEdge(corners);
    return longest > 0 ? areaNormal(corners).norm() / (longest * longest) : 0;
}

class WallCoarsening {
  public:
    WallCoarsening(Workspace& workspace, double factor)
        : workspace_(workspace), mesh_(workspace.mesh), factor_(factor) {}

    int run(const std::vector<int>& triangles) {
        int collapses = 0;
        for (int round = 0; round < kMostCoarsenings; ++round) {
            const int before = collapses;
            for (const ShortEdge& edge : findShortEdges(triangles)) {
                collapses += collapse(edge);
            }
            if (collapses == before) {
                break;
            }
        }
        return collapses;
    }

  private:
    double wantedLengthAt(int t) const { return factor_ * workspace_.edgeLengthAt(t); }
    bool isWall(int t) const { return mesh_.alive(t) && mesh_.kind(t) == SurfaceKind::wall; }

    Edge endsOf(int h) const {
        return edgeOf(mesh_.firstCopy(mesh_.origin(h)), mesh_.firstCopy(mesh_.target(h)));
    }

    /// Each shared edge once, the shortest first.
    std::vector<ShortEdge> findShortEdges(const std::vector<int>& triangles) const {
        std::vector<ShortEdge> edges;
        for (const int t : triangles) {
            if (!isWall(t)) {
                continue;
            }
            const double wanted = wantedLengthAt(t);
            for (int h = 3 * t; h < 3 * t + 3; ++h) {
                if (const double length = edgeLength(mesh_, h); length < kShort * wanted) {
                    edges.push_back({length, endsOf(h), h});
                }
            }
        }
        std::ranges::sort(edges, {}, &ShortEdge::key);
        const auto sameEdge = [](const ShortEdge& a, const ShortEdge& b) {
            return a.ends == b.ends;
        };
        edges.erase(std::unique(edges.begin(), edges.end(), sameEdge), edges.end());
        return edges;
    }

    bool stillThere(const ShortEdge& edge) const {
        const int h = edge.halfEdge;
        return mesh_.alive(h / 3) && endsOf(h) == edge.ends &&
               edgeLength(mesh_, h) < kShort * wantedLengthAt(h / 3);
    }

    // Both points must lie inside: one on the outline could only stay, and then volume could only
    // be kept by moving it.
    bool collapse(const ShortEdge& edge) {
        if (!stillThere(edge)) {
            return false;
        }
        const SharedStar from = starOf(mesh_, edge.ends.first);
        const SharedStar to = starOf(mesh_, edge.ends.second);
        if (!isInsideWall(from) || !isInsideWall(to)) {
            return false;
        }
        workspace_.workAt(edge.halfEdge / 3);
        std::optional<CollapsePlan> best;
        double bestQuality = 0;
        for (const auto& [u, v] : {std::pair(&from, &to), std::pair(&to, &from)}) {
            std::optional<CollapsePlan> plan =
                planCollapse(workspace_, *u, *v, CollapseTarget::end);
            if (!plan) {
                continue;
            }
            if (const double quality = qualityAfter(*plan);
                quality > bestQuality && !addsPiercings(mesh_, plan->rings)) {
                bestQuality = quality;
                best = std::move(plan);
            }
        }
        if (best) {
            carryOut(*best, workspace_);
        }
        return best.has_value();
    }

    /// Of the worst triangle; 0 where an edge becomes too long or a triangle too thin.
    double qualityAfter(const CollapsePlan& plan) const {
        double before = kLeastQuality;
        double after = 1;
        for (const OneRing& ring : plan.rings) {
            for (const int t : ring.before) {
                before = std::min(before, qualityOf(cornersOf(mesh_, t)));
            }
            for (const RingTriangle& t : ring.after) {
                const Corners corners = cornersAfter(mesh_, ring, t);
                after = std::min(after, qualityOf(corners));
                if (longestEdge(corners) > kLong * factor_ * workspace_.edgeLength()) {
                    return 0;
                }
            }
        }
        return after >= before ? after : 0;
    }

    Workspace& workspace_;
    const SurfaceMesh& mesh_;
    double factor_;
};

}  // namespace

int coarsenWalls(Workspace& workspace, const std::vector<int>& triangles, double factor) {
    return WallCoarsening(workspace, factor).run(triangles);
}

}  // namespace kerf::cut
