#include "sim/cut/plan/plan.h"

#include "sim/base/pausing.h"
#include "sim/cut/plan/curves/intersections.h"
#include "sim/cut/plan/seams.h"
#include "sim/cut/plan/strip/flush.h"
#include "sim/cut/plan/strip/swept_strip.h"
#include "sim/cut/plan/wall/skin_map.h"
#include "sim/cut/plan/wall/wall.h"
#include "sim/cut/wall_copies.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/union_find.h"

namespace kerf::cut {

namespace {

/// Counts the groups of neighbours among `touched` triangles, ascending. The paper finds one such
/// triangle, its seed, and walks from there over the adjacency, so it misses groups without a seed,
/// such as a second arm. Here the tree finds all triangles; this only counts the seeds that the
/// walk would need. O(k log k).
int countSeeds(const SurfaceMesh& mesh, const std::vector<int>& touched) {
    const int count = static_cast<int>(touched.size());
    UnionFind groups(count);
    for (int i = 0; i < count; ++i) {
        for (int e = 0; e < 3; ++e) {
            const int neighbour = mesh.twin(3 * touched[i] + e) / 3;
            const auto at = std::lower_bound(touched.begin(), touched.end(), neighbour);
            if (at != touched.end() && *at == neighbour) {
                groups.join(i, static_cast<int>(at - touched.begin()));
            }
        }
    }
    int seeds = 0;
    for (int i = 0; i < count; ++i) {
        seeds += groups.root(i) == i;
    }
    return seeds;
}

constexpr double kRoomAtFrontEnd = 0.3;  // share of the edge length at the end

RungNode airNode(const Strip& strip, int node, double s) {
    return {strip.nodes[node].position, s, -1, false};
}

// W+ turns the triangles of the layout plane over, W- keeps them.
void addWalls(const StepInput& in, const std::vector<WallSheet>& sheets, StepPlan& plan) {
    std::size_t count = plan.triangles.size();
    for (const WallSheet& sheet : sheets) {
        count += 2 * sheet.triangles.size();
    }
    plan.triangles.reserve(count);
    for (const CutSide side : {CutSide::plus, CutSide::minus}) {
        const int label = 2 * in.stroke + (side == CutSide::plus ? 0 : 1);
        for (const WallSheet& sheet : sheets) {
            for (const Triangle& t : sheet.triangles) {
                Triangle c{};
                for (int i = 0; i < 3; ++i) {
                    c[i] = cornerId(in.mesh, plan.curves, t[i]);
                }
                if (side == CutSide::plus) {
                    std::swap(c[1], c[2]);
                }
                plan.triangles.push_back({c, side, SurfaceKind::wall, label});
            }
        }
    }
}

/// Where a corner of a new triangle lies, now or at rest.
const Vec3& placeOf(const SurfaceMesh& mesh, const StepPlan& plan, int corner, bool atRest) {
    if (corner < mesh.vertexCount()) {
        return atRest ? mesh.restPosition(corner) : mesh.position(corner);
    }
    const CutNode& node = plan.curves.nodes[corner - mesh.vertexCount()];
    return atRest ? node.rest : node.position;
}

Corners placesOf(const SurfaceMesh& mesh, const StepPlan& plan, const Triangle& t, bool atRest) {
    return {placeOf(mesh, plan, t[0], atRest), placeOf(mesh, plan, t[1], atRest),
            placeOf(mesh, plan, t[2], atRest)};
}

/// Summed about a corner: about a far origin rounding would be all that is left.
double volumeChange(const SurfaceMesh& mesh, const StepPlan& plan, bool atRest) {
    if (plan.triangles.empty()) {
        return 0;
    }
    const Vec3 origin = placeOf(mesh, plan, plan.triangles.front().corners[0], atRest);
    const auto volumeOf = [&](const Triangle& t) {
        const auto [a, b, c] = placesOf(mesh, plan, t, atRest);
        return tetrahedronVolume(a - origin, b - origin, c - origin);
    };
    double added = 0;
    for (const NewTriangle& t : plan.triangles) {
        added += volumeOf(t.corners);
    }
    double removed = 0;
    for (const int t : plan.subdivision.replaced) {
        removed += volumeOf(mesh.triangle(t));
    }
    return added - removed;
}

void measureVolumeChange(const StepInput& in, StepPlan& plan) {
    const auto lies = [](const CutNode& node) { return node.position == node.rest; };
    const bool atRest = in.atRest && std::ranges::all_of(plan.curves.nodes, lies);
    plan.restVolumeChange = volumeChange(in.mesh, plan, true);
    plan.volumeChange = atRest ? plan.restVolumeChange : volumeChange(in.mesh, plan, false);
}

/// That of the walls of one side.
SweptArea sweptArea(const SurfaceMesh& mesh, const StepPlan& plan) {
    SweptArea swept;
    for (const NewTriangle& t : plan.triangles) {
        if (t.side == CutSide::plus) {
            swept.add({triangleArea(placesOf(mesh, plan, t.corners, false)),
                       triangleArea(placesOf(mesh, plan, t.corners, true))});
        }
    }
    return swept;
}

void requireFinite(const CutCurves& curves) {
    for (const CutNode& node : curves.nodes) {
        if (!node.position.allFinite() || !node.rest.allFinite() || !node.velocity.allFinite()) {
            throw StepFailure{"a new vertex is not finite"};
        }
    }
}

// Strip, curves and outline. The new rung has no nodes at the parameters `skipped`.
Strip layOut(const StepInput& in, const std::vector<double>& skipped, StepPlan& plan) {
    pausePoint();
    PredicatePositions positions(in);
    Strip strip = buildStrip(in, positions, skipped);
    if (in.attempt.staysInPlane) {
        seeFlushAside(in, strip, positions);
    }
    plan.endA = airNode(strip, strip.newRung.front(), in.span.from);
    plan.endB = airNode(strip, strip.newRung.back(), in.span.to);
    plan.curves = intersect(in, strip, positions);
    pausePoint();
    plan.outline = traceOutline(in, strip, RestGuess(in, strip, plan.curves), plan.curves);
    plan.curves.append(plan.outline.nodes);
    return strip;
}

// Of inner points of the new front that lie close to one of its ends on the surface. The material
// could carry them out through the surface, which is only known roughly there.
std::vector<double> crowdedParameters(const StepInput& in, const StepPlan& plan) {
    std::vector<double> crowded;
    const auto isEnd = [&](const FrontPoint& p) {
        return plan.curves.nodes[p.node].kind != NodeKind::wall;
    };
    const std::vector<FrontPoint>& front = plan.outline.front;
    for (std::size_t i = 0; i + 1 < front.size(); ++i) {
        const double length = (plan.curves.nodes[front[i].node].position -
                               plan.curves.nodes[front[i + 1].node].position)
                                  .norm();
        if (!front[i].attached || isEnd(front[i]) == isEnd(front[i + 1])) {
            continue;
        }
        const FrontPoint& end = isEnd(front[i]) ? front[i] : front[i + 1];
        const double edge = in.edgeLengths.localEdgeLength(plan.curves.nodes[end.node].rest);
        if (length < kRoomAtFrontEnd * edge) {
            crowded.push_back(isEnd(front[i]) ? front[i + 1].s : front[i].s);
        }
    }
    return crowded;
}

/// The stroke and the corners of a wall triangle.
using WallKey = std::pair<int, std::array<PointKey, 3>>;
/// By how many the triangles of W+ outnumber those of W-.
using Balance = std::map<WallKey, int>;

class MirrorCheck {
  public:
    MirrorCheck(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance)
        : mesh_(mesh), plan_(plan), closeDistance_(closeDistance) {}

    bool holds() {
        for (const int t : plan_.subdivision.replaced) {
            if (!isClosedWall(t)) {
                continue;
            }
            const int mirror = mirrorOf(mesh_, t);
            if (mirror < 0) {
                continue;
            }
            if (!std::ranges::binary_search(plan_.subdivision.replaced, mirror)) {
                return false;
            }
            mirrored_.push_back(t);
        }
        return mirrored_.empty() || dividesAlike();
    }

  private:
    bool isClosedWall(int t) const {
        return mesh_.kind(t) == SurfaceKind::wall &&
               std::ranges::all_of(mesh_.triangle(t), [&](int v) { return isClosed(v); });
    }

    bool isClosed(int v) const {
        const int group = mesh_.copyGroup(v);
        if (group < 0) {
            return true;
        }
        const std::vector<int>& copies = mesh_.copiesOfGroup(group);
        const Vec3& first = mesh_.position(copies.front());
        return std::ranges::all_of(copies, [&](int copy) {
            return (mesh_.position(copy) - first).norm() <= closeDistance_;
        });
    }

    bool dividesAlike() {
        nodes_ = pointKeys(mesh_, plan_.curves);
        Balance balance;
        const Subdivision& subdivision = plan_.subdivision;
        for (int i = 0; i < sizeOf(subdivision.triangles); ++i) {
            if (std::ranges::binary_search(mirrored_, subdivision.parents[i])) {
                add(subdivision.triangles[i], balance);
            }
        }
        return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
    }

    void add(const NewTriangle& t, Balance& balance) const {
        WallKey key{t.wallLabel / 2,
                    {keyOf(t.corners[0]), keyOf(t.corners[1]), keyOf(t.corners[2])}};
        std::ranges::sort(key.second);
        balance[key] += t.wallLabel % 2 == 0 ? 1 : -1;
    }

    PointKey keyOf(int corner) const {
        return corner < mesh_.vertexCount() ? PointKey{mesh_.firstCopy(corner), -1, -1, -1}
                                            : nodes_[corner - mesh_.vertexCount()];
    }

    const SurfaceMesh& mesh_;
    const StepPlan& plan_;
    double closeDistance_;
    std::vector<int> mirrored_;  ///< closed walls of both sides that the step replaces, ascending
    std::vector<PointKey> nodes_;
};

}  // namespace

PlannedStep planStep(const StepInput& in) {
    PlannedStep step;
    StepPlan& plan = step.plan;
    Strip strip = layOut(in, {}, plan);
    if (const std::vector<double> crowded = crowdedParameters(in, plan); !crowded.empty()) {
        strip = layOut(in, crowded, plan);
    }
    pausePoint();
    if (plan.outline.edges.empty()) {
        step.air = true;
        return step;
    }
    plan.curves = withSeams(in, std::move(plan.curves));
    plan.subdivision = subdivide(in.mesh, plan.curves, kCloseNoise * in.h);
    pausePoint();
    const Wall wall = triangulateWall(in, strip, plan.outline, plan.curves);
    plan.curves.append(wall.nodes);
    pausePoint();
    plan.curves.nodes = mapFromSkin(in, wall.sheets, std::move(plan.curves.nodes));
    pausePoint();
    plan.retraces = !in.opening.empty();
    plan.triangles = plan.subdivision.triangles;
    addWalls(in, wall.sheets, plan);
    plan.partners = glue(in.mesh, plan.curves, plan.outline, plan.subdivision, plan.triangles);
    pausePoint();
    measureVolumeChange(in, plan);
    requireFinite(plan.curves);
    step.swept = sweptArea(in.mesh, plan);
    step.seeds = countSeeds(in.mesh, plan.subdivision.replaced);
    step.wallTriangles = sizeOf(plan.triangles) - sizeOf(plan.subdivision.triangles);
    return step;
}

bool keepsMirrors(const SurfaceMesh& mesh, const StepPlan& plan, double closeDistance) {
    return MirrorCheck(mesh, plan, closeDistance).holds();
}

}  // namespace kerf::cut
