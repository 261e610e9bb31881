#include "sim/cut/cleanup/cleanup.h"

#include "sim/base/containers.h"
#include "sim/base/pausing.h"
#include "sim/cut/cleanup/acceptance.h"
#include "sim/cut/cleanup/collapse.h"
#include "sim/cut/cleanup/flip.h"
#include "sim/cut/cleanup/self_piercing.h"
#include "sim/cut/cleanup/slide.h"

namespace kerf::cut {

namespace {

constexpr int kMostFlipsAtATriangle = 6;

/// One of its corners is on a rim or where sheets meet. Inside a sheet nothing passes through
/// anything.
bool isAtOutline(const SurfaceMesh& mesh, int triangle) {
    bool found = false;
    for (const int v : mesh.triangle(triangle)) {
        mesh.forEachOutgoing(
            v, [&](int h) { found = found || mesh.wallLabel(h / 3) != mesh.wallLabel(triangle); });
    }
    return found;
}

bool flipAnyEdge(Workspace& workspace, int triangle) {
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (flipEdgeApart(workspace, h)) {
            return true;
        }
    }
    return false;
}

bool flipBeside(Workspace& workspace, int triangle) {
    const std::vector<int> pierced = piercedNeighbours(workspace.mesh, triangle);
    if (pierced.empty()) {
        return false;
    }
    workspace.workAt(triangle);
    if (flipAnyEdge(workspace, triangle)) {
        return true;
    }
    for (const int other : pierced) {
        if (flipAnyEdge(workspace, other)) {
            return true;
        }
    }
    return false;
}

/// Flips edges where triangles at one vertex intersect, until they do not or no flip helps: the
/// chords of a curved wall intersect the skin beside its rim where the cut grazes it. Looks at
/// `triangles` (slots, some may be dead). Returns the number of flips.
int partSurface(Workspace& workspace, const std::vector<int>& triangles) {
    int flips = 0;
    const SurfaceMesh& mesh = workspace.mesh;
    for (const int t : triangles) {
        for (int i = 0; i < kMostFlipsAtATriangle && mesh.alive(t); ++i) {
            if (!isAtOutline(mesh, t) || !flipBeside(workspace, t)) {
                break;
            }
            ++flips;
        }
    }
    return flips;
}

constexpr int kMostRounds = 10;
// Of two collapses the better is the one with the better worst triangle, less this for the whole
// of the allowed deviation; one that reaches kGoodEnough ends the search.
constexpr double kPriceOfDeviation = 0.2;
constexpr double kGoodEnough = 0.6;
// Of neighbours around what is cleaned: what an operation judges beside it.
constexpr int kFollowedRings = 3;

struct Sliver {
    double score;
    int triangle;
    bool operator<(const Sliver& other) const {
        return std::pair(score, triangle) < std::pair(other.score, other.triangle);
    }
};

/// One run over a set of triangles.
class SliverRemoval {
  public:
    explicit SliverRemoval(Workspace& workspace) : workspace_(workspace), mesh_(workspace.mesh) {}

    CleanupStatistics run(std::vector<int> triangles) {
        for (int round = 0; round < kMostRounds; ++round) {
            const std::vector<Sliver> slivers = findSlivers(std::move(triangles));
            if (!improveAll(slivers)) {
                break;
            }
            triangles = workspace_.takeChanged();
            if (round == 0) {  // what failed may succeed beside what changed
                for (const Sliver& sliver : slivers) {
                    triangles.push_back(sliver.triangle);
                }
            }
        }
        return statistics_;
    }

  private:
    double scoreOf(int t) const { return triangleScore(mesh_, t, workspace_.goodEdgeLengthAt(t)); }
    bool isGood(int t) const { return scoreOf(t) >= 1; }

    /// The worst first.
    std::vector<Sliver> findSlivers(std::vector<int> triangles) const {
        sortUnique(triangles);
        std::vector<Sliver> slivers;
        for (const int t : triangles) {
            if (mesh_.alive(t) && !isGood(t)) {
                slivers.push_back({scoreOf(t), t});
            }
        }
        std::sort(slivers.begin(), slivers.end());
        return slivers;
    }

    bool improveAll(const std::vector<Sliver>& slivers) {
        bool any = false;
        for (const Sliver& sliver : slivers) {
            pausePoint();
            if (mesh_.alive(sliver.triangle) && !isGood(sliver.triangle) &&
                !workspace_.trianglesTouchRung({sliver.triangle})) {
                any = improve(sliver.triangle) || any;
            }
        }
        return any;
    }

    bool improve(int t) {
        workspace_.workAt(t);
        if (const std::optional<CollapsePlan> plan = bestCollapse(t)) {
            carryOut(*plan, workspace_);
            ++statistics_.collapses;
            return true;
        }
        if (flipEdge(workspace_, edgesByLength(mesh_, t)[2])) {
            ++statistics_.flips;
            return true;
        }
        if (slideVertex(workspace_, t)) {
            ++statistics_.slides;
            return true;
        }
        return false;
    }

    double worth(const CollapsePlan& plan) const {
        return plan.score - kPriceOfDeviation * plan.deviation / workspace_.mostDeviation();
    }

    std::optional<CollapsePlan> bestCollapse(int t) const {
        const Triangle& corners = mesh_.triangle(t);
        const std::array<SharedStar, 3> stars{starOf(mesh_, corners[0]), starOf(mesh_, corners[1]),
                                              starOf(mesh_, corners[2])};
        std::optional<CollapsePlan> best;
        for (const int h : edgesByLength(mesh_, t)) {
            if (edgeLength(mesh_, h) > kLongestCollapse * workspace_.edgeLength()) {
                break;
            }
            const SharedStar& u = stars[h % 3];
            const SharedStar& v = stars[(h + 1) % 3];
            if (u.point == v.point) {
                continue;
            }
            consider(u, v, best);
            consider(v, u, best);
            if (best && worth(*best) >= kGoodEnough) {
                break;
            }
        }
        return best;
    }

    void consider(const SharedStar& from, const SharedStar& to,
                  std::optional<CollapsePlan>& best) const {
        for (const CollapseTarget target : {CollapseTarget::end, CollapseTarget::middle}) {
            std::optional<CollapsePlan> plan = planCollapse(workspace_, from, to, target);
            if (plan && (!best || worth(*plan) > worth(*best)) &&
                !addsPiercings(mesh_, plan->rings)) {
                best = std::move(plan);
            }
        }
    }

    Workspace& workspace_;
    const SurfaceMesh& mesh_;
    CleanupStatistics statistics_;
};

}  // namespace

Cleanup::Cleanup(SurfaceMesh& mesh, const EdgeLengthField& edgeLengths)
    : workspace_(mesh, edgeLengths), firstTriangle_(mesh.triangleSlots()) {}

CleanupStatistics Cleanup::behindFront(const std::vector<RungNode>& rung, CutDelta& delta) {
    workspace_.followMesh();
    workspace_.keepAround(rung);
    std::vector<int> triangles = std::exchange(lastStep_, delta.addedTriangles);
    lastStep_.insert(lastStep_.end(), delta.changedTriangles.begin(), delta.changedTriangles.end());
    triangles.insert(triangles.end(), lastStep_.begin(), lastStep_.end());
    return clean(triangles, delta);
}

void Cleanup::addVertices(std::vector<int>& vertices) const {
    const SurfaceMesh& mesh = workspace_.mesh;
    std::vector<int> found;
    for (const int t : lastStep_) {
        if (mesh.alive(t)) {
            const Triangle& corners = mesh.triangle(t);
            found.insert(found.end(), corners.begin(), corners.end());
        }
    }
    sortUnique(found);
    for (int ring = 0; ring < kFollowedRings; ++ring) {
        for (std::size_t i = found.size(); i-- > 0;) {
            mesh.forEachOutgoing(found[i], [&](int h) { found.push_back(mesh.target(h)); });
        }
        sortUnique(found);
    }
    vertices.insert(vertices.end(), found.begin(), found.end());
}

CleanupStatistics Cleanup::atEnd(CutDelta& delta) {
    workspace_.followMesh();
    workspace_.keepAround({});
    std::vector<int> triangles = std::exchange(lastStep_, {});
    const std::vector<int> ofStroke = trianglesOfStroke();
    triangles.insert(triangles.end(), ofStroke.begin(), ofStroke.end());
    CleanupStatistics statistics = clean(triangles, delta);
    sortUnique(triangles);
    statistics.flips += partSurface(workspace_, triangles);
    workspace_.moveChangesTo(delta);
    statistics.volumeSpent = workspace_.volumeSpent();
    return statistics;
}

CleanupStatistics Cleanup::mend(const std::vector<int>& triangles, CutDelta& delta) {
    workspace_.keepAround({});
    workspace_.exchangeShapes();
    const CleanupStatistics statistics = clean(triangles, delta);
    workspace_.exchangeShapes();
    return statistics;
}

std::vector<int> Cleanup::trianglesOfStroke() const {
    std::vector<int> triangles(workspace_.mesh.triangleSlots() - firstTriangle_);
    std::iota(triangles.begin(), triangles.end(), firstTriangle_);
    return triangles;
}

CleanupStatistics Cleanup::clean(const std::vector<int>& triangles, CutDelta& delta) {
    CleanupStatistics statistics = SliverRemoval(workspace_).run(triangles);
    workspace_.moveChangesTo(delta);
    statistics.volumeSpent = workspace_.volumeSpent();
    return statistics;
}

}  // namespace kerf::cut
