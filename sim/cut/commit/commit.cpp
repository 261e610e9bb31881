#include "sim/cut/commit/commit.h"

#include "sim/base/containers.h"
#include "sim/cut/plan/edge_repair.h"

namespace kerf::cut {

namespace {

class Commit {
  public:
    Commit(SurfaceMesh& mesh, const StepPlan& plan, double h, int stroke,
           const std::vector<RungNode>& staying)
        : mesh_(mesh),
          plan_(plan),
          h_(h),
          stroke_(stroke),
          staying_(staying),
          keys_(pointKeys(mesh, plan.curves)) {}

    CommitResult run() {
        result_.delta.firstNewVertex = oldVertices_ = mesh_.vertexCount();
        firstTriangle_ = mesh_.triangleSlots();
        removeReplaced();
        addTriangles();
        nameVertices();
        joinCopiesOfCurves();
        buildRung();
        if (!plan_.retraces) {
            joinCopiesOfRung();
        }
        repairDuplicateEdges();
        finishDelta();
        return std::move(result_);
    }

  private:
    void removeReplaced() {
        for (const int t : plan_.subdivision.replaced) {
            mesh_.removeTriangle(t);
        }
        result_.delta.removedTriangles = plan_.subdivision.replaced;
    }

    void addTriangles() {
        for (const NewTriangle& t : plan_.triangles) {
            mesh_.addTriangle(t.corners, t.kind, t.wallLabel);
        }
        const int offset = 3 * firstTriangle_;
        for (int h = 0; h < sizeOf(plan_.partners); ++h) {
            const GluePartner& partner = plan_.partners[h];
            if (partner.newHalfEdge >= 0) {
                mesh_.setTwin(offset + h, offset + partner.newHalfEdge);
            } else {
                mesh_.setTwin(offset + h, partner.meshHalfEdge);
                mesh_.setTwin(partner.meshHalfEdge, offset + h);
            }
        }
    }

    void nameVertices() {
        vertexOfNode_.assign(plan_.curves.nodes.size(), -1);
        std::vector<char> seen(plan_.partners.size(), 0);
        umbrellas_.spokes.reserve(2 * seen.size());
        umbrellas_.ends.reserve(seen.size() / 2);
        for (int h = 0; h < sizeOf(seen); ++h) {
            if (seen[h] != 0) {
                continue;
            }
            const int start = 3 * firstTriangle_ + h;
            const int vertex = newVertex(plan_.triangles[h / 3].corners[h % 3]);
            int spoke = start;
            do {
                if (spoke >= 3 * firstTriangle_) {
                    seen[spoke - 3 * firstTriangle_] = 1;
                } else if (mesh_.origin(spoke) != vertex) {
                    result_.delta.changedTriangles.push_back(spoke / 3);
                }
                mesh_.setCorner(spoke / 3, spoke % 3, vertex);
                umbrellas_.spokes.push_back(spoke);
                spoke = mesh_.rotate(spoke);
            } while (spoke != start);
            umbrellas_.ends.push_back(sizeOf(umbrellas_.spokes));
            mesh_.setOutgoing(vertex, start);
        }
    }

    // The vertex for the next umbrella of a corner.
    int newVertex(int corner) {
        return corner < oldVertices_ ? keepOrCopy(corner) : addNode(corner - oldVertices_);
    }

    int keepOrCopy(int v) {
        if (mesh_.outgoing(v) < 3 * firstTriangle_) {  // a new half-edge once it is kept
            return v;
        }
        const int copy = mesh_.addVertex(Vec3(mesh_.position(v)), Vec3(mesh_.restPosition(v)),
                                         Vec3(mesh_.velocity(v)));
        mesh_.joinCopies(v, copy);
        ++result_.splitVertices;
        return copy;
    }

    int addNode(int id) {
        const CutNode& node = plan_.curves.nodes[id];
        const int vertex = mesh_.addVertex(node.position, node.rest, node.velocity);
        if (node.onSeam) {
            result_.onSeams.push_back(vertex);
        }
        if (vertexOfNode_[id] < 0) {
            vertexOfNode_[id] = vertex;
        } else {
            mesh_.joinCopies(vertexOfNode_[id], vertex);
            ++result_.splitVertices;
        }
        return vertex;
    }

    int vertexOf(int node) const {
        const CutNode& n = plan_.curves.nodes[node];
        return n.kind == NodeKind::vertex ? n.a : vertexOfNode_[node];
    }

    // Where the strip crosses an older slit it meets both walls in copies of the same vertices; the
    // vertices at the tip of the slit have no copies and stand for themselves.
    void joinCopiesOfCurves() {
        std::map<PointKey, int> known;
        const auto join = [&](int node) {
            if (const int vertex = vertexOfNode_[node]; vertex >= 0) {
                const auto [at, isNew] = known.emplace(keys_[node], vertex);
                if (!isNew) {
                    mesh_.joinCopies(at->second, vertex);
                }
            }
        };
        for (const auto& [edge, hits] : plan_.curves.onEdge) {
            for (const EdgeHit& hit : hits) {
                join(hit.node);
            }
        }
        for (const auto& [key, node] : plan_.curves.onFace) {
            join(node);
        }
    }

    void buildRung() {
        std::vector<RungNode>& rung = result_.rung;
        const std::vector<FrontPoint>& front = plan_.outline.front;
        if (!plan_.outline.endAInside) {
            rung.push_back(plan_.endA);
        }
        for (int k = sizeOf(front) - 1; k >= 0; --k) {
            const int vertex = vertexOf(front[k].node);
            // The flags run from B to A, the rung from A to B.
            rung.push_back(
                {mesh_.position(vertex), front[k].s, vertex, k > 0 && front[k - 1].attached});
        }
        if (!plan_.outline.endBInside) {
            rung.push_back(plan_.endB);
        }
        for (int k = 1; k < sizeOf(rung); ++k) {
            rung[k].s = std::max(rung[k].s, rung[k - 1].s);
        }
    }

    // The front leaves one wall of an older slit and enters the other.
    void joinCopiesOfRung() {
        const std::set<int> onOldWalls = frontVerticesOnWalls();
        const std::vector<RungNode>& rung = result_.rung;
        for (int k = 0; k + 1 < sizeOf(rung); ++k) {
            const int u = rung[k].vertex;
            const int v = rung[k + 1].vertex;
            if (!rung[k].attached && u != v && onOldWalls.count(u) > 0 && onOldWalls.count(v) > 0 &&
                (rung[k].position - rung[k + 1].position).norm() < kCloseDistance * h_) {
                mesh_.joinCopies(u, v);
            }
        }
    }

    std::set<int> frontVerticesOnWalls() const {
        std::set<int> result;
        for (const FrontPoint& point : plan_.outline.front) {
            const CutNode& node = plan_.curves.nodes[point.node];
            if (node.kind == NodeKind::face && mesh_.kind(node.a) == SurfaceKind::wall) {
                result.insert(vertexOf(point.node));
            }
        }
        return result;
    }

    static void addFrontEdges(const std::vector<RungNode>& rung, std::set<Edge>& edges) {
        for (int k = 0; k + 1 < sizeOf(rung); ++k) {
            if (rung[k].attached) {
                edges.insert(edgeOf(rung[k].vertex, rung[k + 1].vertex));
            }
        }
    }

    void repairDuplicateEdges() {
        if (!hasDuplicateEdges(mesh_, umbrellas_)) {
            return;
        }
        std::set<Edge> frontEdges;
        addFrontEdges(result_.rung, frontEdges);
        addFrontEdges(staying_, frontEdges);
        const std::vector<int> changed =
            splitDuplicateEdges(mesh_, firstTriangle_, stroke_, frontEdges);
        std::vector<int>& relabelled = result_.delta.changedTriangles;
        relabelled.insert(relabelled.end(), changed.begin(), changed.end());
    }

    void finishDelta() {
        CutDelta& delta = result_.delta;
        for (int t = firstTriangle_; t < mesh_.triangleSlots(); ++t) {
            delta.addedTriangles.push_back(t);
        }
        sortUnique(delta.changedTriangles);
    }

    SurfaceMesh& mesh_;
    const StepPlan& plan_;
    double h_;
    int stroke_;
    const std::vector<RungNode>& staying_;
    std::vector<PointKey> keys_;  ///< by node
    int oldVertices_ = 0;
    int firstTriangle_ = 0;
    std::vector<int> vertexOfNode_;
    Umbrellas umbrellas_;  ///< of all vertices of the new triangles
    CommitResult result_;
};

}  // namespace

CommitResult commit(SurfaceMesh& mesh, const StepPlan& plan, double h, int stroke,
                    const std::vector<RungNode>& staying) {
    return Commit(mesh, plan, h, stroke, staying).run();
}

}  // namespace kerf::cut
