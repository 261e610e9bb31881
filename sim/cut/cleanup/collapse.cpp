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
    Collapse(const Workspace& workspace, const MaterialStar& from, const MaterialStar& to,
             CollapseTarget target)
        : workspace_(workspace), mesh_(workspace.mesh), from_(from), to_(to), target_(target) {}

    std::optional<CollapsePlan> run() {
        if (!keepsFeatures() || !keepsMaterialComplex(from_, to_)) {
            return std::nullopt;
        }
        std::optional<CopyPairing> pairing = pairCopies(mesh_, from_, to_);
        if (!pairing || !mayMeetInTheMiddle(*pairing) || !keepsMeshComplex(mesh_, pairing->edges)) {
            return std::nullopt;
        }
        makePatches(*pairing);
        if (workspace_.touchesRung(plan_.patches) || !movesOnlyOneCorner() || !place() ||
            !improves() || !keepsOrientation(workspace_, plan_.patches) || !staysNear()) {
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
        const MaterialEdge* edge = from_.edgeTo(to_.point);
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
               (!to_.isCorner() && from_.featureCount() == to_.featureCount() &&
                pairing.isOneToOne(from_, to_));
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
            plan_.patches.push_back(patchOfMerge(mesh_, from_, to_, v, std::move(merged)));
            aim(plan_.patches.back());
        }
        for (const int u : pairing.unpaired) {
            plan_.patches.push_back(patchOfMove(mesh_, from_, u));
            plan_.patches.back().joins = true;
            aimJoining(plan_.patches.back());
        }
    }

    void aim(Patch& patch) const {
        const int v = patch.vertex;
        patch.position = mesh_.position(v);
        patch.rest = mesh_.restPosition(v);
        patch.velocity = mesh_.velocity(v);
        if (target_ == CollapseTarget::middle) {
            const int u = patch.merged.front();
            patch.position = 0.5 * (patch.position + mesh_.position(u));
            patch.rest = 0.5 * (patch.rest + mesh_.restPosition(u));
            patch.velocity = 0.5 * (patch.velocity + mesh_.velocity(u));
        }
    }

    // In a closed slit all copies meet at one place; in an open one each goes the same way.
    void aimJoining(Patch& patch) const {
        const int v = to_.copies[0];
        patch.rest = mesh_.restPosition(v);
        patch.position = mesh_.position(v);
        patch.velocity = mesh_.velocity(v);
        if (!closed_) {
            const auto count = static_cast<double>(plan_.merges.size());
            patch.position = mesh_.position(patch.vertex);
            patch.velocity = mesh_.velocity(patch.vertex);
            for (const auto& [gone, kept] : plan_.merges) {
                patch.position += (mesh_.position(kept) - mesh_.position(gone)) / count;
                patch.velocity += (mesh_.velocity(kept) - mesh_.velocity(gone)) / count;
            }
        }
    }

    // Volumes are linear in the place of the point only where a triangle meets it once.
    bool movesOnlyOneCorner() const {
        const auto isMoving = [&](int v) {
            const int point = mesh_.materialPoint(v);
            return point == from_.point || point == to_.point;
        };
        return std::all_of(plan_.patches.begin(), plan_.patches.end(), [&](const Patch& patch) {
            return std::all_of(patch.after.begin(), patch.after.end(), [&](const PatchTriangle& t) {
                return std::count_if(t.corners.begin(), t.corners.end(), isMoving) == 1;
            });
        });
    }

    bool place() {
        plan_.defect = placeByVolume(workspace_, plan_.patches);
        return workspace_.allows(plan_.defect, isWallOnly(mesh_, plan_.patches));
    }

    bool improves() {
        const Scores after = scoresAfter(workspace_, plan_.patches);
        plan_.score = after.worst;
        return cut::improves(scoresBefore(workspace_, plan_.patches), after);
    }

    bool staysNear() {
        double moved = deviationOf(mesh_, from_, to_, plan_.patches);
        if (from_.isCorner()) {
            moved = std::max(moved, edgeLength());
        }
        plan_.deviation = moved + std::max(workspace_.deviationAt(from_.copies),
                                           workspace_.deviationAt(to_.copies));
        return plan_.deviation <= workspace_.mostDeviation();
    }

    const Workspace& workspace_;
    const SurfaceMesh& mesh_;
    const MaterialStar& from_;
    const MaterialStar& to_;
    CollapseTarget target_;
    bool closed_ = false;
    CollapsePlan plan_;
};

}  // namespace

std::optional<CollapsePlan> planCollapse(const Workspace& workspace, const MaterialStar& from,
                                         const MaterialStar& to, CollapseTarget target) {
    return Collapse(workspace, from, to, target).run();
}

}  // namespace kerf::cut
