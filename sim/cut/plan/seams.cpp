#include "sim/cut/plan/seams.h"

#include <algorithm>
#include <set>

namespace kerf::cut {

namespace {

class Seams {
  public:
    Seams(const StepInput& in, CutCurves& curves) : mesh_(in.mesh), curves_(curves) {
        for (const auto& [v, way] : in.opening.displacements()) {
            opened_.insert(mesh_.firstCopy(v));
        }
    }

    void run() {
        const std::map<Edge, std::vector<EdgeHit>> onEdge = curves_.onEdge;
        for (const auto& [edge, hits] : onEdge) {
            if (isOpened(edge)) {
                faceEdge(edge, hits);
            }
        }
        const std::map<std::pair<int, int>, int> onFace = curves_.onFace;
        for (const auto& [key, node] : onFace) {
            if (const int facing = facingWall(key.second); facing >= 0) {
                faceNode(key.first, key.second, facing, node);
            }
        }
        const std::vector<Segment> segments = curves_.segments;
        for (const Segment& segment : segments) {
            if (const int facing = facingWall(segment.triangle); facing >= 0) {
                faceSegment(segment, facing);
            }
        }
    }

  private:
    bool isOpened(int v) const { return opened_.count(mesh_.firstCopy(v)) > 0; }
    bool isOpened(const Edge& edge) const { return isOpened(edge.first) || isOpened(edge.second); }

    std::vector<int> copiesOf(int v) const {
        return mesh_.copyGroup(v) < 0 ? std::vector<int>{v}
                                      : mesh_.copiesOfGroup(mesh_.copyGroup(v));
    }

    bool isWallEdge(int h) const {
        return mesh_.kind(h / 3) == SurfaceKind::wall ||
               mesh_.kind(mesh_.twin(h) / 3) == SurfaceKind::wall;
    }

    void faceEdge(const Edge& edge, const std::vector<EdgeHit>& hits) {
        if (!isWallEdge(mesh_.findHalfEdge(edge.first, edge.second))) {
            return;
        }
        for (const int u : copiesOf(edge.first)) {
            for (const int v : copiesOf(edge.second)) {
                const int h = mesh_.outgoing(u) < 0 ? -1 : mesh_.findHalfEdge(u, v);
                if (h >= 0 && edgeOf(u, v) != edge) {
                    addHits(hits, edge.first, u, v, h);
                }
            }
        }
    }

    // u is the copy of `first`. Seen open, the two walls may be met at different points of the
    // edge; both take the same one.
    void addHits(const std::vector<EdgeHit>& hits, int first, int u, int v, int h) {
        std::vector<EdgeHit>& facing = curves_.onEdge[edgeOf(u, v)];
        for (const EdgeHit& hit : hits) {
            const bool forwards = curves_.nodes[hit.node].a == first;
            const CutNode node = facingEdgeNode(hit.node, forwards ? u : v, forwards ? v : u);
            const auto known = std::find_if(facing.begin(), facing.end(), [&](const EdgeHit& k) {
                return k.stripTriangle == hit.stripTriangle;
            });
            if (known == facing.end()) {
                facing.push_back({hit.stripTriangle, addSeamNode(node)});
            } else {
                moveTo(node, curves_.nodes[known->node]);
            }
        }
        orderAlong(facing);
        curves_.segmentsOfTriangle[h / 3];
        curves_.segmentsOfTriangle[mesh_.twin(h) / 3];
    }

    int addSeamNode(CutNode node) {
        node.onSeam = true;
        curves_.nodes.push_back(node);
        return sizeOf(curves_.nodes) - 1;
    }

    static void moveTo(const CutNode& place, CutNode& node) {
        node.a = place.a;
        node.b = place.b;
        node.t = place.t;
        node.weights = place.weights;
        node.position = place.position;
        node.rest = place.rest;
        node.velocity = place.velocity;
    }

    CutNode facingEdgeNode(int source, int a, int b) const {
        CutNode node = curves_.nodes[source];
        const auto shift = [&](auto&& quantity) {
            return Vec3((1 - node.t) * (quantity(a) - quantity(node.a)) +
                        node.t * (quantity(b) - quantity(node.b)));
        };
        node.position += shift([&](int v) { return mesh_.position(v); });
        node.rest += shift([&](int v) { return mesh_.restPosition(v); });
        node.velocity += shift([&](int v) { return mesh_.velocity(v); });
        node.a = a;
        node.b = b;
        return node;
    }

    // All from the same end, ascending.
    void orderAlong(std::vector<EdgeHit>& hits) {
        const int start = curves_.nodes[hits.front().node].a;
        for (const EdgeHit& hit : hits) {
            CutNode& node = curves_.nodes[hit.node];
            if (node.a != start) {
                std::swap(node.a, node.b);
                node.t = 1 - node.t;
            }
        }
        std::sort(hits.begin(), hits.end(), [&](const EdgeHit& p, const EdgeHit& q) {
            const double tp = curves_.nodes[p.node].t;
            const double tq = curves_.nodes[q.node].t;
            return tp != tq ? tp < tq : p.stripTriangle < q.stripTriangle;
        });
    }

    /// The corner of triangle t that is a copy of v, -1 where there is none.
    int copyIn(int t, int v) const {
        for (const int corner : mesh_.triangle(t)) {
            if (mesh_.firstCopy(corner) == mesh_.firstCopy(v)) {
                return corner;
            }
        }
        return -1;
    }

    bool faces(int t, int other) const {
        const Triangle& c = mesh_.triangle(t);
        return mesh_.kind(other) == SurfaceKind::wall &&
               mesh_.wallLabel(other) == (mesh_.wallLabel(t) ^ 1) &&
               std::all_of(c.begin(), c.end(), [&](int v) { return copyIn(other, v) >= 0; });
    }

    /// The mirror of an opened wall triangle, -1 for others.
    int facingWall(int t) const {
        const Triangle& c = mesh_.triangle(t);
        if (mesh_.kind(t) != SurfaceKind::wall ||
            std::none_of(c.begin(), c.end(), [&](int v) { return isOpened(v); })) {
            return -1;
        }
        int found = -1;
        for (const int copy : copiesOf(c[0])) {
            mesh_.forEachOutgoing(copy, [&](int h) {
                if (found < 0 && faces(t, h / 3)) {
                    found = h / 3;
                }
            });
        }
        return found;
    }

    int cornerOf(int t, int v) const {
        const Triangle& c = mesh_.triangle(t);
        return static_cast<int>(std::find(c.begin(), c.end(), v) - c.begin());
    }

    void faceNode(int stripEdge, int t, int facing, int source) {
        CutNode node = curves_.nodes[source];
        const Vec3 weights = node.weights;
        node.a = facing;
        for (int i = 0; i < 3; ++i) {
            const int from = mesh_.triangle(t)[i];
            const int to = copyIn(facing, from);
            node.weights[cornerOf(facing, to)] = weights[i];
            node.position += weights[i] * (mesh_.position(to) - mesh_.position(from));
            node.rest += weights[i] * (mesh_.restPosition(to) - mesh_.restPosition(from));
            node.velocity += weights[i] * (mesh_.velocity(to) - mesh_.velocity(from));
        }
        const auto known = curves_.onFace.find({stripEdge, facing});
        if (known != curves_.onFace.end()) {
            moveTo(node, curves_.nodes[known->second]);
            return;
        }
        const int id = addSeamNode(node);
        curves_.onFace[{stripEdge, facing}] = id;
        curves_.faceNodesOfTriangle[facing].push_back(id);
    }

    void faceSegment(const Segment& segment, int facing) {
        const int from = nodeIn(facing, segment, segment.from);
        const int to = nodeIn(facing, segment, segment.to);
        std::vector<int>& known = curves_.segmentsOfTriangle[facing];
        const bool isThere = std::any_of(known.begin(), known.end(), [&](int i) {
            const Segment& s = curves_.segments[i];
            return edgeOf(s.from, s.to) == edgeOf(from, to);
        });
        if (!isThere) {
            known.push_back(sizeOf(curves_.segments));
            curves_.segments.push_back({facing, segment.stripTriangle, to, from});
        }
    }

    /// What stands for the end of a segment in the facing triangle.
    int nodeIn(int facing, const Segment& segment, int id) {
        const CutNode node = curves_.nodes[id];
        if (node.kind == NodeKind::vertex) {
            const int copy = copyIn(facing, node.a);
            return curves_.vertexNode(mesh_, copy, node.layout);
        }
        if (node.kind == NodeKind::face) {
            return curves_.onFace.at({node.stripEdge, facing});
        }
        const Edge edge = edgeOf(copyIn(facing, node.a), copyIn(facing, node.b));
        const auto hits = curves_.onEdge.find(edge);
        if (hits != curves_.onEdge.end()) {
            for (const EdgeHit& hit : hits->second) {
                if (hit.stripTriangle == segment.stripTriangle) {
                    return hit.node;
                }
            }
        }
        throw StepFailure{"a seam does not meet the edge that it faces"};
    }

    const SurfaceMesh& mesh_;
    CutCurves& curves_;
    std::set<int> opened_;  ///< first copies of vertices of which a copy is seen elsewhere
};

}  // namespace

void addSeams(const StepInput& in, CutCurves& curves) {
    if (!in.opening.empty()) {
        Seams(in, curves).run();
    }
}

}  // namespace kerf::cut
