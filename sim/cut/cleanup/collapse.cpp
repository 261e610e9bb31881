#include "sim/cut/cleanup/collapse.h"

#include "sim/cut/cleanup/acceptance.h"
#include "sim/cut/cleanup/copies.h"
#include "sim/cut/cleanup/deviation.h"
#include "sim/cut/cleanup/placement.h"

namespace kerf::cut {

namespace {

/// The copies of a point and those of its neighbour into which they merge.
struct CopyPairing {
    std::vector<int> edges;     ///< half-edges from the copy that goes to the one that stays
    std::vector<int> unpaired;  ///< copies without an edge to the neighbour

    /// Whether every copy of either point has a partner of its own.
    bool isOneToOne(const SurfaceMesh& mesh, const SharedStar& to) const {
        std::set<int> partners;
        for (const int h : edges) {
            partners.insert(mesh.target(h));
        }
        return unpaired.empty() && edges.size() == to.copies.size() &&
               partners.size() == to.copies.size();
    }
};

constexpr int kLeastValence = 3;

std::vector<int> neighbours(const SurfaceMesh& mesh, int v) {
    std::vector<int> result;
    mesh.forEachOutgoing(v, [&](int h) { result.push_back(mesh.target(h)); });
    return result;
}

bool contains(const std::vector<int>& list, int value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

/// Pairs the copies of two neighbours along their edges. Nothing where a copy has several partners
/// (the slit would close) or no copy has one.
std::optional<CopyPairing> pairCopies(const SurfaceMesh& mesh, const SharedStar& from,
                                      const SharedStar& to) {
    CopyPairing pairing;
    for (const int u : from.copies) {
        std::vector<int> edges;
        mesh.forEachOutgoing(u, [&](int h) {
            if (contains(to.copies, mesh.target(h))) {
                edges.push_back(h);
            }
        });
        if (edges.size() > 1) {
            return std::nullopt;
        }
        if (edges.empty()) {
            pairing.unpaired.push_back(u);
        } else {
            pairing.edges.push_back(edges[0]);
        }
    }
    return pairing.edges.empty() ? std::nullopt : std::optional(std::move(pairing));
}

/// Whether the link condition holds with all slits closed: common neighbours are apexes of the
/// shared edge, and no two features merge.
bool keepsSharedComplex(const SharedStar& from, const SharedStar& to) {
    const SharedEdge& between = *from.edgeTo(to.point);
    return std::all_of(from.edges.begin(), from.edges.end(), [&](const SharedEdge& edge) {
        const SharedEdge* other = edge.neighbour == to.point ? nullptr : to.edgeTo(edge.neighbour);
        return other == nullptr ||
               (between.hasApex(edge.neighbour) && !(edge.isFeature() && other->isFeature()));
    });
}

/// Whether the mesh stays a simple complex (I3) after the collapse of these half-edges, one after
/// the other, and every apex keeps three triangles.
bool keepsMeshComplex(const SurfaceMesh& mesh, const std::vector<int>& edges) {
    std::vector<std::pair<int, int>> added;
    std::map<int, int> lost;  // triangles by apex
    for (const int h : edges) {
        const int kept = mesh.target(h);
        const int left = mesh.apex(h);
        const int right = mesh.apex(mesh.twin(h));
        if (left == right) {
            return false;
        }
        ++lost[left];
        ++lost[right];
        const std::vector<int> known = neighbours(mesh, kept);
        for (const int x : neighbours(mesh, mesh.origin(h))) {
            if (x == kept || x == left || x == right) {
                continue;
            }
            if (contains(known, x)) {
                return false;
            }
            added.emplace_back(kept, x);
        }
    }
    std::sort(added.begin(), added.end());
    return std::adjacent_find(added.begin(), added.end()) == added.end() &&
           std::all_of(lost.begin(), lost.end(), [&](const std::pair<const int, int>& apex) {
               return valence(mesh, apex.first) - apex.second >= kLeastValence;
           });
}

//        left                  left
//       / |  \                  |  \      the triangles beside a -> b go; their outer
//     a --h-- b      ->         b         neighbours become neighbours of each other
//       \ |  /                  |  /
//        right                 right
/// Collapses half-edge h: its origin's triangles become its target's, two triangles go. Returns
/// those two; the origin has no triangle afterwards.
std::array<int, 2> collapseHalfEdge(SurfaceMesh& mesh, int h) {
    const int g = mesh.twin(h);
    const int a = mesh.origin(h), b = mesh.target(h);
    const int left = mesh.apex(h), right = mesh.apex(g);
    std::vector<int> spokes;
    mesh.forEachOutgoing(a, [&](int spoke) { spokes.push_back(spoke); });
    const int leftToB = mesh.twin(SurfaceMesh::next(h));
    const int aToLeft = mesh.twin(SurfaceMesh::previous(h));
    const int rightToA = mesh.twin(SurfaceMesh::next(g));
    const int bToRight = mesh.twin(SurfaceMesh::previous(g));
    for (const int spoke : spokes) {
        if (spoke / 3 != h / 3 && spoke / 3 != g / 3) {
            mesh.setCorner(spoke / 3, spoke % 3, b);
        }
    }
    mesh.link(leftToB, aToLeft);
    mesh.link(rightToA, bToRight);
    mesh.setOutgoing(b, aToLeft);
    mesh.setOutgoing(left, leftToB);
    mesh.setOutgoing(right, rightToA);
    return {h / 3, g / 3};
}

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
                from_.featureCount() == to_.featureCount() && pairing.isOneToOne(mesh_, to_));
    }

    void makePatches(const CopyPairing& pairing) {
        const VertexPositions places = VertexPositions::current(mesh_);
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
        return plan_.deviation <= workspace_.mostDeviation() &&
               unfacedDeviation(workspace_, plan_.rings) <= kMostUnfaced * workspace_.edgeLength();
    }

    const Workspace& workspace_;
    const SurfaceMesh& mesh_;
    const SharedStar& from_;
    const SharedStar& to_;
    CollapseTarget target_;
    bool closed_ = false;
    CollapsePlan plan_;
};

void mergeVertices(const CollapsePlan& plan, Workspace& workspace) {
    SurfaceMesh& mesh = workspace.mesh;
    for (const auto& [gone, kept] : plan.merges) {
        for (const int t : collapseHalfEdge(mesh, mesh.findHalfEdge(gone, kept))) {
            workspace.removeTriangle(t);
        }
        workspace.removeVertex(gone);
    }
}

// What is left of the point that goes consists of copies of the one that stays.
void joinMates(const CollapsePlan& plan, SurfaceMesh& mesh) {
    for (const OneRing& ring : plan.rings) {
        if (ring.joins) {
            mesh.leaveCopies(ring.vertex);
        }
    }
    for (const OneRing& ring : plan.rings) {
        if (ring.joins) {
            mesh.joinCopies(plan.to, ring.vertex);
        }
    }
}

}  // namespace

std::optional<CollapsePlan> planCollapse(const Workspace& workspace, const SharedStar& from,
                                         const SharedStar& to, CollapseTarget target) {
    return Collapse(workspace, from, to, target).run();
}

void carryOut(const CollapsePlan& plan, Workspace& workspace) {
    mergeVertices(plan, workspace);
    joinMates(plan, workspace.mesh);
    std::vector<int> copies;
    for (const OneRing& ring : plan.rings) {
        workspace.moveVertex(ring);
        copies.push_back(ring.vertex);
    }
    workspace.setDeviation(copies, plan.deviation);
    workspace.spend(plan.defect);
}

}  // namespace kerf::cut
