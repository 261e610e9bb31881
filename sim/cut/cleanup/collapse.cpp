#include "sim/cut/cleanup/collapse.h"

#include <algorithm>

#include "sim/cut/cleanup/acceptance.h"
#include "sim/cut/cleanup/collapse_topology.h"
#include "sim/cut/cleanup/deviation.h"
#include "sim/cut/cleanup/limits.h"
#include "sim/cut/cleanup/placement.h"

namespace kerf::cut {

namespace {

class Collapse {
  public:
    Collapse(const Workspace& workspace, const SharedStar& from, const SharedStar& to,
             CollapseTarget target)
        : workspace_(workspace), mesh_(workspace.mesh), from_(from), to_(to), target_(target) {}

    std::optional<CollapsePlan> run() {
        if (workspace_.isKept(from_.copies) || !keepsFeatures() ||
            !keepsSharedComplex(from_, to_)) {
            return std::nullopt;
        }
        std::optional<CopyPairing> pairing = pairCopies(mesh_, from_, to_);
        if (!pairing || !mayMeetInTheMiddle(*pairing) || !keepsMeshComplex(mesh_, pairing->edges)) {
            return std::nullopt;
        }
        makePatches(*pairing);
        if (workspace_.touchesRung(plan_.rings) || !movesOnlyOneCorner() || !place() ||
            !improves() || !keepsOrientation(workspace_, plan_.rings) || !staysNear()) {
            return std::nullopt;
        }
        plan_.from = from_.copies[0];
        plan_.to = to_.copies[0];
        return std::move(plan_);
    }

  private:
    // A point on a feature line may only go along the line; a corner only to a place so near that
    // the lines hardly move (two T-junctions become one crossing).
    bool keepsFeatures() const {
        if (from_.featureCount() == 0) {
            return true;
        }
        const SharedEdge* edge = from_.edgeTo(to_.point);
        if (!edge->isFeature()) {
            return false;
        }
        return !from_.isCorner() ||
               (target_ == CollapseTarget::end && edgeLength() <= workspace_.mostDeviation());
    }

    double edgeLength() const {
        for (const int u : from_.copies) {
            for (const int v : to_.copies) {
                if (const int h = mesh_.findHalfEdge(u, v); h >= 0) {
                    return cut::edgeLength(mesh_, h);
                }
            }
        }
        return 0;
    }

    bool mayMeetInTheMiddle(const CopyPairing& pairing) const {
        return target_ == CollapseTarget::end ||
               (!workspace_.isKept(to_.copies) && !to_.isCorner() &&
                from_.featureCount() == to_.featureCount() && pairing.isOneToOne(from_, to_));
    }

    void makePatches(const CopyPairing& pairing) {
        const VertexPlaces places = VertexPlaces::current(mesh_);
        closed_ = haveOnePlace(places, from_.copies, workspace_.edgeLength()) &&
                  haveOnePlace(places, to_.copies, workspace_.edgeLength());
        for (const int h : pairing.edges) {
            plan_.merges.emplace_back(mesh_.origin(h), mesh_.target(h));
        }
        for (const int v : to_.copies) {
            std::vector<int> merged;
            for (const auto& [gone, kept] : plan_.merges) {
                if (kept == v) {
                    merged.push_back(gone);
                }
            }
            plan_.rings.push_back(ringOfMerge(mesh_, from_, to_, v, std::move(merged)));
            aim(plan_.rings.back());
        }
        for (const int u : pairing.unpaired) {
            plan_.rings.push_back(ringOfMove(mesh_, from_, u));
            plan_.rings.back().joins = true;
            aimJoining(plan_.rings.back());
        }
    }

    void aim(OneRing& ring) const {
        const int v = ring.vertex;
        ring.position = mesh_.position(v);
        ring.rest = mesh_.restPosition(v);
        ring.velocity = mesh_.velocity(v);
        if (target_ == CollapseTarget::middle) {
            const int u = ring.merged.front();
            ring.position = 0.5 * (ring.position + mesh_.position(u));
            ring.rest = 0.5 * (ring.rest + mesh_.restPosition(u));
            ring.velocity = 0.5 * (ring.velocity + mesh_.velocity(u));
        }
    }

    // In a closed slit all copies meet at one place; in an open one each goes the same way.
    void aimJoining(OneRing& ring) const {
        const int v = to_.copies[0];
        ring.rest = mesh_.restPosition(v);
        ring.position = mesh_.position(v);
        ring.velocity = mesh_.velocity(v);
        if (!closed_) {
            const auto count = static_cast<double>(plan_.merges.size());
            ring.position = mesh_.position(ring.vertex);
            ring.velocity = mesh_.velocity(ring.vertex);
            for (const auto& [gone, kept] : plan_.merges) {
                ring.position += (mesh_.position(kept) - mesh_.position(gone)) / count;
                ring.velocity += (mesh_.velocity(kept) - mesh_.velocity(gone)) / count;
            }
        }
    }

    // Volumes are linear in the place of the point only where a triangle meets it once.
    bool movesOnlyOneCorner() const {
        const auto isMoving = [&](int v) {
            const int point = mesh_.firstCopy(v);
            return point == from_.point || point == to_.point;
        };
        return std::all_of(plan_.rings.begin(), plan_.rings.end(), [&](const OneRing& ring) {
            return std::all_of(ring.after.begin(), ring.after.end(), [&](const RingTriangle& t) {
                return std::count_if(t.corners.begin(), t.corners.end(), isMoving) == 1;
            });
        });
    }

    bool place() {
        plan_.defect = workspace_.isKept(to_.copies) ? volumeDefect(mesh_, plan_.rings)
                                                     : placeByVolume(workspace_, plan_.rings);
        return workspace_.allows(plan_.defect, isWallOnly(mesh_, plan_.rings));
    }

    bool improves() {
        const Scores after = scoresAfter(workspace_, plan_.rings);
        plan_.score = after.worst;
        return cut::improves(scoresBefore(workspace_, plan_.rings), after);
    }

    bool staysNear() {
        double moved = deviationOf(mesh_, from_, to_, plan_.rings);
        if (from_.isCorner()) {
            moved = std::max(moved, edgeLength());
        }
        plan_.deviation = moved + std::max(workspace_.deviationAt(from_.copies),
                                           workspace_.deviationAt(to_.copies));
        return plan_.deviation <= workspace_.mostDeviation();
    }

    const Workspace& workspace_;
    const SurfaceMesh& mesh_;
    const SharedStar& from_;
    const SharedStar& to_;
    CollapseTarget target_;
    bool closed_ = false;
    CollapsePlan plan_;
};

}  // namespace

std::optional<CollapsePlan> planCollapse(const Workspace& workspace, const SharedStar& from,
                                         const SharedStar& to, CollapseTarget target) {
    return Collapse(workspace, from, to, target).run();
}

}  // namespace kerf::cut
