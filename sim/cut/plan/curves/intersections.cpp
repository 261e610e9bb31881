#include "sim/cut/plan/curves/intersections.h"

#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/cut/plan/curves/curve_nodes.h"
#include "sim/cut/plan/strip/front_profile.h"
#include "sim/cut/wall_copies.h"

namespace kerf::cut {

namespace {

// Rows of wall triangles behind the front that the blade can't meet again so soon.
constexpr int kFringeRings = 5;

/// Where the two triangles of a pair meet: from where to where.
struct Ends {
    int entry = -1;
    int exit = -1;
    int count = 0;

    void add(bool isExit, int node) {
        ++count;
        (isExit ? exit : entry) = node;
    }
};

/// Works through all pairs of triangles.
class Intersector {
  public:
    Intersector(const StepInput& in, const Strip& strip, const PredicatePositions& positions)
        : in_(in),
          mesh_(in.mesh),
          strip_(strip),
          positions_(positions),
          front_(in.blade, strip),
          nodes_(in, strip, positions) {
        for (const RungNode& node : in.rung) {
            if (node.vertex >= 0) {
                rungVertices_.push_back(node.vertex);
            }
        }
        sortUnique(rungVertices_);
    }

    CutCurves run() {
        gatherEntries();
        for (int s = 0; s < sizeOf(strip_.triangles); ++s) {
            intersectStripTriangle(s);
        }
        return nodes_.take();
    }

  private:
    void gatherEntries() {
        std::vector<Vec3> points;
        points.reserve(strip_.nodes.size());
        inFrame_.reserve(strip_.nodes.size());
        for (const StripNode& node : strip_.nodes) {
            points.push_back(node.position);
            inFrame_.push_back(in_.broadPhase.toFrame(node.position));
        }
        std::vector<int> near = in_.broadPhase.cover(points, drift_);
        const std::vector<BroadPhase::Entry>& entries = in_.broadPhase.entries();
        seenOf_.assign(entries.size(), -1);
        std::erase_if(near, [&](int place) {
            const int m = entries[place].triangle;
            const Triangle& ids = mesh_.triangle(m);
            const Corners at{positions_.at(ids[0]), positions_.at(ids[1]), positions_.at(ids[2])};
            if (isOwnWall(m) && front_.isBehind(ids, at)) {
                return true;
            }
            seenOf_[place] = sizeOf(seen_);
            seen_.emplace_back(ids, at);
            return false;
        });
        ahead_ = in_.broadPhase.binsOf(near);
    }

    // How far from its real position a vertex may be seen.
    double predicateDrift() const {
        const Attempt& attempt = in_.attempt;
        const double closing = attempt.onSurface ? kCloseDistance : attempt.closing;
        const double shares = closing + 2 * attempt.tolerance;
        return shares * in_.h + in_.opening.reach() + positions_.asideReach();
    }

    // Most triangles of a strip lie inside the body, near nothing but walls behind the front.
    void intersectStripTriangle(int s) {
        const Triangle& ids = strip_.triangles[s];
        const Bounds box = boxOf(ids, [this](int node) { return inFrame_[node]; });
        in_.broadPhase.findEntries(box, drift_, ahead_, found_);
        if (found_.empty()) {
            return;
        }
        stripVertices_.clear();
        Corners at;
        for (int j = 0; j < 3; ++j) {
            at[j] = strip_.nodes[ids[j]].position;
            for (const int v : strip_.nodes[ids[j]].vertices) {
                stripVertices_.push_back({v, j});
            }
        }
        const StripTriangle strip(s, ids, at);
        for (const int entry : found_) {
            SeenTriangle& mesh = seen_[seenOf_[entry]];
            const TrianglePair pair{mesh, strip, sharedVertex(mesh.ids)};
            // Walls of this stroke may lie in the plane of the blade, where signs cost the most:
            // most of those that do not lie behind the front are told apart before.
            if (pair.shared.count < 2 && !areApart(pair)) {
                mesh.putInOrder();
                intersectPair(pair, in_.broadPhase.entries()[entry].triangle);
            }
        }
    }

    SharedVertex sharedVertex(const Triangle& ids) const {
        SharedVertex shared;
        for (const auto& [v, stripCorner] : stripVertices_) {
            for (int i = 0; i < 3; ++i) {
                if (ids[i] == v) {
                    shared = {shared.count + 1, v, i, stripCorner};
                }
            }
        }
        return shared;
    }

    /// `m`: the slot of the mesh triangle.
    void intersectPair(const TrianglePair& pair, int m) {
        const std::optional<PairSigns> signs = signsOf(pair);
        if (!signs) {
            return;
        }
        Ends ends;
        meshEdgesAgainstStrip(pair, *signs, ends);
        stripEdgesAgainstMesh(pair, *signs, m, ends);
        if (ends.count == 0) {
            return;
        }
        if (pair.shared.any()) {
            if (ends.count != 1) {
                throw StepFailure{"two triangles meet twice beside a shared vertex"};
            }
            ends.add(ends.exit < 0, nodes_.atSharedVertex(pair));
        }
        if (ends.count != 2 || ends.entry < 0 || ends.exit < 0) {
            throw StepFailure{"two triangles meet in an impossible way"};
        }
        if (isFringe(m)) {
            throw StepFailure{"the blade meets the walls that it has just made"};
        }
        nodes_.join(m, pair.strip.index, ends.entry, ends.exit);
    }

    void meshEdgesAgainstStrip(const TrianglePair& pair, const PairSigns& signs, Ends& ends) {
        const Triangle& ids = pair.mesh.ids;
        for (int i = 0; i < 3; ++i) {
            if (pair.shared.isOnMeshEdge(i) || (onRung(ids[i]) && onRung(ids[(i + 1) % 3]))) {
                continue;
            }
            if (const auto crossing = meshEdgeCrossing(pair, signs, i)) {
                ends.add(crossing->isExit, nodes_.onEdge(pair, *crossing));
            }
        }
    }

    void stripEdgesAgainstMesh(const TrianglePair& pair, const PairSigns& signs, int m,
                               Ends& ends) {
        for (int i = 0; i < 3; ++i) {
            const int edge = strip_.triangleEdges[pair.strip.index][i];
            if (pair.shared.isOnStripEdge(i) ||
                strip_.edges[edge].frontOf == in_.pieceOfVertex[pair.mesh.ids[0]]) {
                continue;
            }
            if (const auto crossing = stripEdgeCrossing(pair, signs, i)) {
                ends.add(crossing->isExit, nodes_.onFace(pair, m, edge, *crossing));
            }
        }
    }

    bool onRung(int v) const { return std::ranges::binary_search(rungVertices_, v); }

    bool isOwnWall(int m) const { return strokeOf(mesh_, m) == in_.stroke; }

    /// Vertices of walls near the rung. Few steps ask.
    const std::set<int>& fringe() {
        if (!fringe_.empty()) {
            return fringe_;
        }
        fringe_ = {rungVertices_.begin(), rungVertices_.end()};
        for (int ring = 1; ring < kFringeRings; ++ring) {
            std::set<int> wider = fringe_;
            for (const int v : fringe_) {
                mesh_.forEachOutgoing(v, [&](int h) {
                    if (mesh_.kind(h / 3) == SurfaceKind::wall) {
                        wider.insert({mesh_.target(h), mesh_.apex(h)});
                    }
                });
            }
            fringe_ = std::move(wider);
        }
        return fringe_;
    }

    /// A wall of this transit beside its front. Those of earlier transits of the stroke may be
    /// crossed; what a cut leaves of them has corners older than the transit.
    bool isFringe(int m) {
        const Triangle& ids = mesh_.triangle(m);
        return isOwnWall(m) &&
               std::ranges::all_of(ids, [&](int v) { return v >= in_.firstVertexOfTransit; }) &&
               std::ranges::any_of(ids, [&](int v) { return fringe().contains(v); });
    }

    const StepInput& in_;
    const SurfaceMesh& mesh_;
    const Strip& strip_;
    const PredicatePositions& positions_;
    FrontProfile front_;
    CurveNodes nodes_;
    std::vector<int> rungVertices_;    ///< ascending
    double drift_ = predicateDrift();  ///< how far from its place a vertex may be seen [m]
    std::vector<Vec3> inFrame_;        ///< the nodes of the strip along the axes of the broad phase
    std::vector<SeenTriangle> seen_;   ///< of the entries that do not lie behind the front
    std::vector<int> seenOf_;          ///< places there, by entry of the broad phase; -1 for others
    BroadPhase::Bins ahead_;           ///< entries that do not lie behind the front
    std::vector<int> found_;
    std::vector<std::pair<int, int>> stripVertices_;  ///< of the strip triangle in hand: corners
    std::set<int> fringe_;                            ///< empty until fringe() is asked
};

}  // namespace

CutCurves intersect(const StepInput& in, const Strip& strip, const PredicatePositions& positions) {
    return Intersector(in, strip, positions).run();
}

}  // namespace kerf::cut
